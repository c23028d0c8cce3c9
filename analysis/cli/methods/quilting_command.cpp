// SPDX-License-Identifier: MIT
// Quilting: options, bake reports, and descriptions for `inspect`.
#include "quilting_command.h"

#include <lichen/quilting.h>

#include <fmt/format.h>

namespace lichen::cli {
namespace {

using Json = nlohmann::ordered_json;

/// Where tiles are taken from.
std::string tileWords(const QuiltingNoise& noise) {
  return noise.offsets.empty() ? "from anywhere"
                               : fmt::format("at {} offsets", noise.offsets.size());
}

class Bake final : public BakeOptions {
public:
  explicit Bake(const CommonOptions& common) : common_(common) {}

  [[nodiscard]] BakeMemory memory() const override { return {32.0, 128.0}; }

  [[nodiscard]] Result<MethodBake> bake(const BakeInput& input) const override {
    QuiltingOptions options;
    options.bits = input.bits;
    options.periodic = input.borders;
    options.guide = common_.guide;
    options.progress = input.progress;
    Result<QuiltingBake> baked = bakeQuilting(input.name, input.maps, options);
    if (!baked)
      return baked.error();
    QuiltingBake& bake = baked.value();
    const auto& shared = bake.noise.as<QuiltingNoise>();
    MethodBake result;
    result.bordersWereBlended = bake.bordersWereCut;
    result.borderTreatment = "cuts";
    result.json["periodic"] = !bake.bordersWereCut;
    result.json["strength"] = bake.strength;
    result.json["offsets"] = shared.offsets.size();
    if (shared.grain != Grain::none) {
      result.json["grain"] = nameOf(shared.grain);
      result.facts.emplace_back("Grain", fmt::format("along {}", nameOf(shared.grain)));
    }
    result.facts.emplace_back("Borders", bake.bordersWereCut ? "cut" : "left as they were");
    result.facts.emplace_back("Repeats", fmt::format("{:.2f} of 1", bake.strength));
    result.facts.emplace_back("Tiles", tileWords(shared));
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
QuiltingCommand::addBakeOptions(CLI::App&, const CommonOptions& common) const {
  return std::make_unique<Bake>(common);
}

std::unique_ptr<const UseOptions> QuiltingCommand::addSynthOptions(CLI::App&) const {
  return std::make_unique<Use>();
}

std::unique_ptr<const UseOptions> QuiltingCommand::addApplyOptions(CLI::App&) const {
  return std::make_unique<Use>();
}

void QuiltingCommand::describe(const Noise& noise, Json& json) const {
  const auto& shared = noise.as<QuiltingNoise>();
  if (shared.grain != Grain::none)
    json["grain"] = nameOf(shared.grain);
  json["reach"] = shared.reach;
  json["correlation"] = shared.correlation;
  json["offsets"] = shared.offsets;
}

std::vector<std::string> QuiltingCommand::linesOf(const Noise& noise, const MaterialNoise&) const {
  const auto& shared = noise.as<QuiltingNoise>();
  std::vector<std::string> lines{"tiles " + tileWords(shared)};
  if (shared.grain != Grain::none)
    lines.push_back(fmt::format("grain along {}", nameOf(shared.grain)));
  lines.push_back(fmt::format("{} fetches of cells, for all maps together", sharedFetches()));
  return lines;
}

void QuiltingCommand::describe(const Bundle&, const NoiseMap& map, Json& json) const {
  const auto& own = map.as<QuiltingMap>();
  json["image"] = own.image;
  json["cells"] = own.cells;
}

std::vector<std::string> QuiltingCommand::linesOf(const Bundle&, const NoiseMap& map) const {
  const auto& own = map.as<QuiltingMap>();
  return {fmt::format("image: table {}", own.image), fmt::format("cells: table {}", own.cells)};
}

int QuiltingCommand::fetches(const Bundle&, const Noise&, const NoiseMap&,
                             const MaterialNoise&) const {
  return 2; // of the image: the two tiles of most weight
}

int QuiltingCommand::sharedFetches() const {
  return 3; // of the cells of all tiles at a point
}

bool QuiltingCommand::hasRows(const Noise& noise) const {
  return !noise.as<QuiltingNoise>().offsets.empty();
}

const Table& QuiltingCommand::imageOf(const Bundle& bundle, const NoiseMap& map) const {
  return bundle.tables[map.as<QuiltingMap>().image];
}

} // namespace lichen::cli
