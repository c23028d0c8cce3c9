// SPDX-License-Identifier: MIT
// Local random-phase noise: options, bake reports, and descriptions for `inspect`.
#include "local_random_phase_command.h"

#include "../table_words.h"

#include <lichen/counted.h>
#include <lichen/local_random_phase.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lichen::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kHeading = "Local random phase";

std::string offsetWords(const CosineStructure& structure) {
  return structure.offsets > 0 ? counted(std::uint64_t(structure.offsets), "offset")
                               : "any offsets";
}

class Bake final : public BakeOptions {
public:
  explicit Bake(const CommonOptions& common) : common_(common) {}

  int cosines = 0;
  std::optional<double> structure;
  double turbulence = 0.0;

  /// As tiling needs, and the spectra of all channels. A structure is at most four times as large
  /// as its exemplar, with levels in floats and in texels, twice if there is a list.
  [[nodiscard]] BakeMemory memory() const override {
    const bool mayHaveStructure = structure != 0.0;
    return {64.0, mayHaveStructure ? 460.0 : 160.0};
  }

  [[nodiscard]] Result<MethodBake> bake(const BakeInput& input) const override {
    if (common_.spectrum && structure.value_or(0.0) > 0.0)
      return Error{ErrorKind::usage,
                   fmt::format("--structure {} with --spectrum: a given spectrum has no structure; "
                               "expected --structure 0 or auto",
                               *structure)};
    LocalRandomPhaseOptions options;
    options.cosines = cosines;
    options.structure = structure;
    options.guide = common_.guide;
    options.turbulence = turbulence;
    if (Result<void> given = setSpectrum(common_.spectrum, input.maps, options.spectrum); !given)
      return given.error();
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
    result.json["structure"] = bake.structure;
    result.json["offsets"] = shared.structure.offsets;
    if (bake.structure > 0.0)
      result.facts.emplace_back("Structure", fmt::format("{:.2f} of the power, {}", bake.structure,
                                                         offsetWords(shared.structure)));
    if (bake.structure > 0.0 && !structure)
      result.notes.push_back(
          fmt::format("the exemplar repeats, so {:.0f} % of its variation keeps its structure; for "
                      "none, as solids need: --structure 0",
                      100.0 * bake.structure));
    if (bake.structure == 0.0 && (common_.guide || turbulence > 0.0))
      result.notes.push_back(fmt::format("{} has no effect, since the noise has no structure",
                                         common_.guide ? "--guide" : "--turbulence"));
    result.noise = std::move(bake.noise);
    result.tables = std::move(bake.tables);
    return result;
  }

private:
  const CommonOptions& common_;
};

/// The method has no parameters of a material.
class Use final : public UseOptions {
public:
  void replace(MaterialNoise&, EvaluationOptions&) const override {}
};

} // namespace

std::unique_ptr<const BakeOptions>
LocalRandomPhaseCommand::addBakeOptions(CLI::App& verb, const CommonOptions& common) const {
  auto options = std::make_unique<Bake>(common);
  addValue(verb, "--cosines", options->cosines,
           wholeNumber(int(kCosinesRange.least), int(kCosinesRange.most)), "50",
           "Number of cosines; more follow the spectrum more closely and cost more per pixel")
      .group(kHeading);
  addValue(verb, "--structure", options->structure, orAuto(number(kStructureRange)), "auto",
           "Share of the power with the exemplar's phases, and so its structure; auto: "
           "as clearly as the exemplar repeats")
      .group(kHeading);
  addValue(verb, "--turbulence", options->turbulence, number(kTurbulenceRange, "tiles"), "0",
           "Deviation of a smooth random displacement of the structure")
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
  const CosineStructure& structure = shared.structure;
  if (structure.columns > 0)
    json["localRandomPhase"]["structure"] = {{"texels", {structure.columns, structure.rows}},
                                             {"offsets", structure.offsets},
                                             {"turbulence", structure.turbulence}};
}

std::vector<std::string> LocalRandomPhaseCommand::linesOf(const Noise& noise,
                                                          const MaterialNoise&) const {
  const auto& shared = noise.as<LocalRandomPhaseNoise>();
  const auto octaves = std::count_if(shared.cosines.begin(), shared.cosines.end(),
                                     [](int count) { return count > 0; });
  std::vector<std::string> lines{fmt::format("{} in {}",
                                             counted(std::uint64_t(shared.cosineCount()), "cosine"),
                                             counted(std::uint64_t(octaves), "octave"))};
  const CosineStructure& structure = shared.structure;
  if (structure.columns > 0)
    lines.push_back(fmt::format("structure of {} x {} texels, {}", structure.columns,
                                structure.rows, offsetWords(structure)));
  return lines;
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

bool LocalRandomPhaseCommand::hasRows(const Noise& noise) const {
  return noise.as<LocalRandomPhaseNoise>().structure.offsets > 0;
}

int LocalRandomPhaseCommand::fetches(const Bundle&, const Noise& noise, const NoiseMap& map,
                                     const MaterialNoise&) const {
  constexpr int kPerCosine = 2; // four texels, frequencies and three vectors, hold two cosines
  const auto& shared = noise.as<LocalRandomPhaseNoise>();
  // Three by three texels hold the 16 that a spline needs, at two levels.
  constexpr int kPerTile = 2 * 9;
  const bool hasList = shared.structure.offsets > 0; // with its mean, and three look-ups
  const int tiles = shared.structure.columns == 0 ? 0 : hasList ? 4 : 3;
  return kPerCosine * shared.cosineCount() + kPerTile * tiles + (hasList ? 3 : 0) +
         (map.as<LocalRandomPhaseMap>().inverseTable ? 1 : 0);
}

const Table& LocalRandomPhaseCommand::imageOf(const Bundle& bundle, const NoiseMap& map) const {
  return bundle.tables[map.as<LocalRandomPhaseMap>().cosines];
}

} // namespace lichen::cli
