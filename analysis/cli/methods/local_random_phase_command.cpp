// SPDX-License-Identifier: MIT
// Local random-phase noise on the command line: options, bake reports, and descriptions for
// `inspect`.
#include "../table_words.h"
#include "method_command.h"

#include <lichen/counted.h>

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace lichen::cli {
namespace {

constexpr const char* kHeading = "Local random phase";

std::string offsetWords(const CosineStructure& structure) {
  return structure.offsets > 0 ? counted(std::uint64_t(structure.offsets), "offset")
                               : "any offsets";
}

class LocalRandomPhaseCommand final : public MethodCommand {
  std::string heading() const override { return kHeading; }
  bool takesSpectrum() const override { return true; }
  bool takesGuide() const override { return true; }
  std::string optionsFor(Mapping) const override { return "with --structure 0"; }

  BakeOptionsReader addBakeOptions(CLI::App& verb, CommonOptions& common) const override {
    auto options = std::make_shared<LocalRandomPhaseOptions>();
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
    return [options, &common](std::span<const MapExemplar> maps,
                              std::vector<std::string>&) -> Result<MethodOptions> {
      if (common.spectrum && options->structure.value_or(0.0) > 0.0)
        return Error{ErrorKind::usage,
                     fmt::format("--structure {} with --spectrum: a given spectrum has no "
                                 "structure; expected --structure 0 or auto",
                                 *options->structure)};
      LocalRandomPhaseOptions own = *options;
      own.guide = common.guide;
      if (Result<void> given = setSpectrum(common.spectrum, maps, own.spectrum); !given)
        return given.error();
      return MethodOptions(std::move(own));
    };
  }

  Result<Json> figures(const BakedMaterial& baked) const override {
    const auto& shared = baked.bundle.noises.front().as<LocalRandomPhaseNoise>();
    return Json{{"cosines", shared.cosineCount()},
                {"periodic", baked.figures.bordersWereKept},
                {"structure", baked.figures.structure},
                {"offsets", shared.structure.offsets}};
  }

  Facts facts(const BakedMaterial& baked) const override {
    const auto& shared = baked.bundle.noises.front().as<LocalRandomPhaseNoise>();
    Facts facts{{"Borders", baked.figures.bordersWereKept ? "fit together" : "blended"},
                {"Cosines", std::to_string(shared.cosineCount())}};
    if (const double structure = baked.figures.structure; structure > 0.0)
      facts.emplace_back("Structure", fmt::format("{:.2f} of the power, {}", structure,
                                                  offsetWords(shared.structure)));
    return facts;
  }

  void describe(const Noise& noise, Json& json) const override {
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

  std::vector<std::string> linesOf(const Noise& noise, const MaterialNoise&) const override {
    const auto& shared = noise.as<LocalRandomPhaseNoise>();
    const auto octaves = std::count_if(shared.cosines.begin(), shared.cosines.end(),
                                       [](int count) { return count > 0; });
    std::vector<std::string> lines{
        fmt::format("{} in {}", counted(std::uint64_t(shared.cosineCount()), "cosine"),
                    counted(std::uint64_t(octaves), "octave"))};
    const CosineStructure& structure = shared.structure;
    if (structure.columns > 0)
      lines.push_back(fmt::format("structure of {} x {} texels, {}", structure.columns,
                                  structure.rows, offsetWords(structure)));
    return lines;
  }

  void describe(const NoiseMap& map, Json& json) const override {
    const auto& own = map.as<LocalRandomPhaseMap>();
    json["cosines"] = own.cosines;
    json["inverseTable"] = own.inverseTable ? Json(*own.inverseTable) : Json();
    json["dimensions"] = own.dimensions;
  }

  std::vector<std::string> linesOf(const Bundle& bundle, const NoiseMap& map) const override {
    const auto& own = map.as<LocalRandomPhaseMap>();
    return {fmt::format("cosines: table {}", own.cosines),
            inverseTableWords(own.inverseTable, own.dimensions, bundle.tables)};
  }

  bool hasRows(const Noise& noise) const override {
    return noise.as<LocalRandomPhaseNoise>().structure.offsets > 0;
  }

  int fetches(const Noise& noise, const NoiseMap& map, const MaterialNoise&) const override {
    constexpr int kPerCosine = 2; // four texels, frequencies and three vectors, hold two cosines
    const auto& shared = noise.as<LocalRandomPhaseNoise>();
    // Three by three texels hold the 16 that a spline needs, at two levels.
    constexpr int kPerTile = 2 * 9;
    const bool hasList = shared.structure.offsets > 0; // with its mean, and three look-ups
    const int tiles = shared.structure.columns == 0 ? 0 : hasList ? 4 : 3;
    return kPerCosine * shared.cosineCount() + kPerTile * tiles + (hasList ? 3 : 0) +
           (map.as<LocalRandomPhaseMap>().inverseTable ? 1 : 0);
  }

  std::size_t imageOf(const NoiseMap& map) const override {
    return map.as<LocalRandomPhaseMap>().cosines;
  }
};

} // namespace

const MethodCommand& localRandomPhaseCommand() {
  static const LocalRandomPhaseCommand command;
  return command;
}

} // namespace lichen::cli
