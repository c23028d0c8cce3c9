// SPDX-License-Identifier: MIT
// Quilting on the command line: options, bake reports, and descriptions for `inspect`.
#include "method_command.h"

#include <fmt/format.h>

namespace lichen::cli {
namespace {

/// Where tiles are taken from.
std::string tileWords(const QuiltingNoise& noise) {
  return noise.offsets.empty() ? "from anywhere"
                               : fmt::format("at {} offsets", noise.offsets.size());
}

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

  Result<Json> figures(const BakedMaterial& baked) const override {
    const auto& shared = baked.bundle.noises.front().as<QuiltingNoise>();
    Json json{{"periodic", baked.figures.bordersWereKept},
              {"strength", baked.figures.strength},
              {"offsets", shared.offsets.size()}};
    if (shared.grain != Grain::none)
      json["grain"] = nameOf(shared.grain);
    return json;
  }

  Facts facts(const BakedMaterial& baked) const override {
    const auto& shared = baked.bundle.noises.front().as<QuiltingNoise>();
    Facts facts;
    if (shared.grain != Grain::none)
      facts.emplace_back("Grain", fmt::format("along {}", nameOf(shared.grain)));
    facts.emplace_back("Borders", baked.figures.bordersWereKept ? "left as they were" : "cut");
    facts.emplace_back("Repeats", fmt::format("{:.2f} of 1", baked.figures.strength));
    facts.emplace_back("Tiles", tileWords(shared));
    return facts;
  }

  void describe(const Noise& noise, Json& json) const override {
    const auto& shared = noise.as<QuiltingNoise>();
    if (shared.grain != Grain::none)
      json["grain"] = nameOf(shared.grain);
    json["reach"] = shared.reach;
    json["correlation"] = shared.correlation;
    json["offsets"] = shared.offsets;
  }

  std::vector<std::string> linesOf(const Noise& noise, const MaterialNoise&) const override {
    const auto& shared = noise.as<QuiltingNoise>();
    std::vector<std::string> lines{"tiles " + tileWords(shared)};
    if (shared.grain != Grain::none)
      lines.push_back(fmt::format("grain along {}", nameOf(shared.grain)));
    lines.push_back(fmt::format("{} fetches of cells, for all maps together", sharedFetches()));
    return lines;
  }

  void describe(const NoiseMap& map, Json& json) const override {
    const auto& own = map.as<QuiltingMap>();
    json["image"] = own.image;
    json["cells"] = own.cells;
  }

  std::vector<std::string> linesOf(const Bundle&, const NoiseMap& map) const override {
    const auto& own = map.as<QuiltingMap>();
    return {fmt::format("image: table {}", own.image), fmt::format("cells: table {}", own.cells)};
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
  std::size_t imageOf(const NoiseMap& map) const override { return map.as<QuiltingMap>().image; }
};

} // namespace

const MethodCommand& quiltingCommand() {
  static const QuiltingCommand command;
  return command;
}

} // namespace lichen::cli
