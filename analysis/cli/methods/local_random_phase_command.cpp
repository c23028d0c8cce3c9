// SPDX-License-Identifier: MIT
// Local random-phase noise: options, bake reports, and descriptions for `inspect`.
#include "local_random_phase_command.h"

#include "../table_words.h"

#include <lichen/counted.h>
#include <lichen/local_random_phase.h>

#include <fmt/format.h>

#include <algorithm>

namespace lichen::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kHeading = "Local random phase";

/// Risks that random phases have. Slow variation is not one of them: the noise has it.
bool isOfRandomPhases(const Risk& risk) { return risk.name == "outlines"; }

class Bake final : public BakeOptions {
public:
  int cosines = 0;

  [[nodiscard]] Result<std::vector<std::vector<Risk>>>
  assess(std::span<const MapExemplar> maps, Periodic, const SharedOptions& shared) const override {
    return assessEach(
        maps, shared,
        [](const MapExemplar& map, const Progress& progress) -> Result<std::vector<Risk>> {
          const int support = std::max(map.width, map.height); // nothing is slower than the tile
          Result<std::vector<Risk>> risks = assessTextonSuitability(map, support, progress);
          if (!risks)
            return risks;
          std::vector<Risk> kept;
          std::copy_if(risks.value().begin(), risks.value().end(), std::back_inserter(kept),
                       isOfRandomPhases);
          return kept;
        });
  }

  /// As tiling needs, and the spectra of all channels.
  [[nodiscard]] BakeMemory memory() const override { return {64.0, 160.0}; }

  [[nodiscard]] Result<MethodBake> bake(const BakeInput& input) const override {
    LocalRandomPhaseOptions options;
    options.cosines = cosines;
    options.bits = input.bits;
    options.periodic = input.borders;
    options.progress = input.progress;
    Result<LocalRandomPhaseBake> baked = bakeLocalRandomPhase(input.name, input.maps, options);
    if (!baked)
      return baked.error();
    LocalRandomPhaseBake& bake = baked.value();
    const auto& shared = bake.noise.as<LocalRandomPhaseNoise>();
    MethodBake result;
    result.bordersWereBlended = !bake.exemplarWasPeriodic;
    result.json["cosines"] = shared.cosineCount();
    result.json["periodic"] = bake.exemplarWasPeriodic;
    result.facts.emplace_back("Borders", bake.exemplarWasPeriodic ? "fit together" : "blended");
    result.facts.emplace_back("Cosines", std::to_string(shared.cosineCount()));
    result.noise = std::move(bake.noise);
    result.tables = std::move(bake.tables);
    return result;
  }
};

/// The method has no parameters of a material.
class Use final : public UseOptions {
public:
  void replace(MaterialNoise&, EvaluationOptions&) const override {}
};

} // namespace

std::unique_ptr<const BakeOptions> LocalRandomPhaseCommand::addBakeOptions(CLI::App& verb) const {
  auto options = std::make_unique<Bake>();
  addValue(verb, "--cosines", options->cosines,
           wholeNumber(int(kCosinesRange.least), int(kCosinesRange.most)), "50",
           "Number of cosines; more follow the spectrum more closely and cost more per pixel")
      .group(kHeading);
  return options;
}

std::unique_ptr<const UseOptions> LocalRandomPhaseCommand::addSynthOptions(CLI::App&) const {
  return std::make_unique<Use>();
}

std::unique_ptr<const UseOptions> LocalRandomPhaseCommand::addApplyOptions(CLI::App&) const {
  return std::make_unique<Use>();
}

void LocalRandomPhaseCommand::describe(const Noise& noise, Json& json) const {
  const auto& shared = noise.as<LocalRandomPhaseNoise>();
  json["localRandomPhase"] = {{"cosines", shared.cosineCount()},
                              {"octaves", shared.cosines},
                              {"variants", shared.variants}};
}

std::vector<std::string> LocalRandomPhaseCommand::linesOf(const Noise& noise,
                                                          const MaterialNoise&) const {
  const auto& shared = noise.as<LocalRandomPhaseNoise>();
  const auto octaves = std::count_if(shared.cosines.begin(), shared.cosines.end(),
                                     [](int count) { return count > 0; });
  return {fmt::format("{} in {}", counted(std::uint64_t(shared.cosineCount()), "cosine"),
                      counted(std::uint64_t(octaves), "octave"))};
}

void LocalRandomPhaseCommand::describe(const Bundle&, const NoiseMap& map, Json& json) const {
  const auto& own = map.as<LocalRandomPhaseMap>();
  json["cosines"] = own.cosines;
  json["inverseTable"] = own.inverseTable ? Json(*own.inverseTable) : Json();
  json["dimensions"] = own.dimensions;
}

std::vector<std::string> LocalRandomPhaseCommand::linesOf(const Bundle& bundle,
                                                          const NoiseMap& map) const {
  const auto& own = map.as<LocalRandomPhaseMap>();
  return {fmt::format("cosines: table {}", own.cosines),
          inverseTableWords(own.inverseTable, own.dimensions, bundle.tables)};
}

int LocalRandomPhaseCommand::fetches(const Bundle&, const Noise& noise, const NoiseMap& map,
                                     const MaterialNoise&) const {
  constexpr int kPerCosine = 2; // four texels, frequencies and three vectors, hold two cosines
  const int cosines = noise.as<LocalRandomPhaseNoise>().cosineCount();
  return kPerCosine * cosines + (map.as<LocalRandomPhaseMap>().inverseTable ? 1 : 0);
}

const Table& LocalRandomPhaseCommand::imageOf(const Bundle& bundle, const NoiseMap& map) const {
  return bundle.tables[map.as<LocalRandomPhaseMap>().cosines];
}

} // namespace lichen::cli
