// SPDX-License-Identifier: MIT
// Quilting on the command line: options, bake reports, and descriptions for `inspect`.
#include "method_command.h"

namespace lichen::cli {
namespace {

class QuiltingCommand final : public MethodCommand {
  std::string heading() const override { return "Quilting"; }
  bool takesGuide() const override { return true; }

  BakeOptionsReader addBakeOptions(CLI::App&, CommonOptions& common) const override {
    return [&common](std::span<const MapExemplar>, std::vector<std::string>&) {
      QuiltingOptions options;
      options.guide = common.guide;
      return MethodOptions(options);
    };
  }

  Json figures(const BakedMaterial& baked) const override {
    const auto& shared = baked.bundle.noises.front().as<QuiltingNoise>();
    Json json{{"periodic", baked.figures.bordersWereKept},
              {"strength", baked.figures.strength},
              {"offsets", shared.offsets.size()}};
    if (shared.grain != Grain::none)
      json["grain"] = nameOf(shared.grain);
    return json;
  }

  void describe(const Noise& noise, Json& json) const override {
    const auto& shared = noise.as<QuiltingNoise>();
    if (shared.grain != Grain::none)
      json["grain"] = nameOf(shared.grain);
    json["reach"] = shared.reach;
    json["correlation"] = shared.correlation;
    json["offsets"] = shared.offsets;
  }

  void describe(const NoiseMap& map, Json& json) const override {
    const auto& own = map.as<QuiltingMap>();
    json["image"] = own.image;
    json["cells"] = own.cells;
  }

  bool hasRows(const Noise& noise) const override {
    return !noise.as<QuiltingNoise>().offsets.empty();
  }
  int fetches(const Noise&, const NoiseMap&, const MaterialNoise&) const override {
    return 2; // of the image: the two tiles of most weight
  }
  int sharedFetches() const override {
    return 3; // of the cells of all tiles at a point
  }
};

} // namespace

const MethodCommand& quiltingCommand() {
  static const QuiltingCommand command;
  return command;
}

} // namespace lichen::cli
