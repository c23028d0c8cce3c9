// SPDX-License-Identifier: MIT
// Tiling on the command line: options, bake reports, and descriptions for `inspect`.
#include "method_command.h"

#include <lichen/tiling.h>

#include <memory>

namespace lichen::cli {
namespace {

constexpr const char* kHeading = "Tiling";

class TilingCommand final : public MethodCommand {
  std::string heading() const override { return kHeading; }

  BakeOptionsReader addBakeOptions(CLI::App&, CommonOptions&) const override {
    return [](std::span<const MapExemplar>, std::vector<std::string>&) {
      return MethodOptions(TilingOptions{});
    };
  }

  UseOptions addUseOptions(CLI::App& verb) const override {
    struct Use {
      std::optional<double> sharpness;
      std::optional<std::uint32_t> tileRotation;
    };
    auto options = std::make_shared<Use>();
    addValue(verb, "--sharpness", options->sharpness, optional(number(kBlendSharpnessRange)), "",
             "Exponent of the blend weights [default: the bundle's]")
        .group(kHeading);
    const Choices<std::uint32_t> rotations{{"none", 0}, {"2", 2}, {"4", 4}};
    addValue(verb, "--tile-rotation", options->tileRotation, optional(oneOf(rotations)), "",
             "Random rotation of each tile: by half turns (2); of square tiles by quarter turns "
             "(4) [default: the bundle's]")
        .group(kHeading);
    return [options](MaterialNoise& material) {
      material.blendSharpness = options->sharpness.value_or(material.blendSharpness);
      material.tileRotation = options->tileRotation.value_or(material.tileRotation);
    };
  }

  Json figures(const BakedMaterial& baked) const override {
    const Noise& noise = baked.bundle.noises.front();
    const auto& first = noise.maps.front().as<TilingMap>();
    Json json{{"dimensions", first.dimensions},
              {"periodic", baked.figures.bordersWereKept},
              {"table", nameOf(tableKindOf(first))}};
    describe(noise, json);
    return json;
  }

  void describe(const Noise& noise, Json& json) const override {
    if (const Grain grain = noise.as<TilingNoise>().grain; grain != Grain::none)
      json["grain"] = nameOf(grain);
  }

  void describe(const NoiseMap& map, Json& json) const override {
    const auto& tiling = map.as<TilingMap>();
    json["gaussian"] = tiling.gaussian;
    json["inverseTable"] = tiling.inverseTable ? Json(*tiling.inverseTable) : Json();
    json["table"] = nameOf(tableKindOf(tiling));
    json["dimensions"] = tiling.dimensions;
  }

  /// Texture fetches of shaders_glsl/noise/tiling.glsl: three taps, and one of the inverse table.
  int fetches(const Noise&, const NoiseMap& map, const MaterialNoise&) const override {
    constexpr int kTaps = 3;
    return tableKindOf(map.as<TilingMap>()) == TableKind::none ? kTaps : kTaps + 1;
  }
};

} // namespace

const MethodCommand& tilingCommand() {
  static const TilingCommand command;
  return command;
}

} // namespace lichen::cli
