// SPDX-License-Identifier: MIT
// Local random-phase noise: options, bake reports, and descriptions for `inspect`.
#include "local_random_phase_command.h"

#include "../table_words.h"
#include "spectrum_option.h"

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

std::string offsetWords(const CosineStructure& structure) {
  return structure.offsets > 0 ? counted(std::uint64_t(structure.offsets), "offset")
                               : "any offsets";
}

class Bake final : public BakeOptions {
public:
  int cosines = 0;
  std::optional<double> structure, guide;
  double turbulence = 0.0;
  std::optional<SpectrumChoice> spectrum;

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

  /// As tiling needs, and the spectra of all channels. A structure is at most four times as large
  /// as its exemplar, with levels in floats and in texels, twice if there is a list.
  [[nodiscard]] BakeMemory memory() const override {
    const bool mayHaveStructure = structure != 0.0;
    return {64.0, mayHaveStructure ? 460.0 : 160.0};
  }

  [[nodiscard]] Result<MethodBake> bake(const BakeInput& input) const override {
    LocalRandomPhaseOptions options;
    options.cosines = cosines;
    options.structure = structure;
    options.guide = guide;
    options.turbulence = turbulence;
    if (spectrum) {
      int most = 1; // what the largest map can hold
      for (const MapExemplar& map : input.maps)
        most = std::max(most, std::max(map.width, map.height) / 2);
      Result<SpectrumPicture> picture = spectrumPicture(*spectrum, most);
      if (!picture)
        return picture.error();
      options.spectrum = std::move(picture).value();
    }
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
  addValue(verb, "--structure", options->structure, orAuto(number(kStructureRange)), "auto",
           "Share of the power that keeps the phases of the exemplar, and so its structure; auto: "
           "as clearly as the exemplar repeats")
      .group(kHeading);
  addValue(verb, "--guide", options->guide, orAuto(number(kGuideRange)), "auto",
           "How closely tiles of the structure follow what repeats in the exemplar; 0: not at all")
      .group(kHeading);
  addValue(verb, "--turbulence", options->turbulence, number(kTurbulenceRange, "tiles"), "0",
           "Deviation of a smooth random displacement of the structure")
      .group(kHeading);
  addValue(
      verb, "--spectrum", options->spectrum, spectrumChoice(), "",
      "A spectrum in place of the exemplar's, which gives the colours: a picture of amplitudes, "
      "frequency 0 in the middle and a cycle per tile a pixel; or rings FROM:TO and bands "
      "LEFT:RIGHT:TOP:BOTTOM in cycles per tile")
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
