// SPDX-License-Identifier: MIT
// Local random-phase noise on the command line: options, bake reports, and descriptions for
// `inspect`.
#include "method_command.h"

#include <fmt/format.h>

#include <memory>

namespace lichen::cli {
namespace {

constexpr const char* kHeading = "Local random phase";

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

  Json figures(const BakedMaterial& baked) const override {
    const auto& shared = baked.bundle.noises.front().as<LocalRandomPhaseNoise>();
    return Json{{"cosines", shared.cosineCount()},
                {"periodic", baked.figures.bordersWereKept},
                {"structure", baked.figures.structure},
                {"offsets", shared.structure.offsets}};
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

  void describe(const NoiseMap& map, Json& json) const override {
    const auto& own = map.as<LocalRandomPhaseMap>();
    json["cosines"] = own.cosines;
    json["inverseTable"] = own.inverseTable ? Json(*own.inverseTable) : Json();
    json["dimensions"] = own.dimensions;
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
};

} // namespace

const MethodCommand& localRandomPhaseCommand() {
  static const LocalRandomPhaseCommand command;
  return command;
}

} // namespace lichen::cli
