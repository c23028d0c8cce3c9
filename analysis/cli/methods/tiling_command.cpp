// SPDX-License-Identifier: MIT
// Tiling: options, bake reports, and descriptions for `inspect`.
#include "tiling_command.h"

#include "../table_words.h"

#include <lichen/tiling.h>
#include <lichen/tiling_precision.h>

#include <fmt/format.h>

#include <algorithm>

namespace lichen::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kHeading = "Tiling";

// ---- bake ----

Json asJson(const PrecisionLoss& loss) {
  Json json{
      {"mean", loss.mean}, {"variance", loss.variance}, {"colorDistance", loss.colorDistance}};
  if (loss.roundTrip)
    json["roundTrip"] = *loss.roundTrip;
  return json;
}

class Bake final : public BakeOptions {
public:
  TilingOptions options;

  /// Measured: 139 to 148 bytes per pixel for one map of 512 to 2048 pixels a side, 161 for one of
  /// 8192 (docs/benchmarks.md), 238 for four maps of 1024.
  [[nodiscard]] BakeMemory memory() const override { return {32.0, 128.0}; }

  [[nodiscard]] Result<MethodBake> bake(const BakeInput& input) const override {
    TilingOptions tiling = options;
    tiling.bits = input.bits;
    tiling.periodic = input.borders;
    tiling.progress = input.progress;
    Result<TilingBake> baked = bakeTiling(input.name, input.maps, tiling);
    if (!baked)
      return baked.error();
    TilingBake& bake = baked.value();
    MethodBake result;
    result.bordersWereBlended = !bake.exemplarWasPeriodic;
    const auto& first = bake.noise.maps.front().as<TilingMap>();
    constexpr int kMostDimensions = 3; // a fourth channel is unused
    result.json["dimensions"] =
        std::min(kMostDimensions, channelCount(bake.tables[first.gaussian].format));
    result.json["periodic"] = bake.exemplarWasPeriodic;
    result.json["table"] = nameOf(tableKindOf(first));
    result.facts.emplace_back("Borders", bake.exemplarWasPeriodic ? "fit together" : "blended");
    if (const Grain grain = bake.noise.as<TilingNoise>().grain; grain != Grain::none) {
      result.json["grain"] = nameOf(grain);
      result.facts.emplace_back("Grain", fmt::format("along {}", nameOf(grain)));
      result.notes.push_back(
          fmt::format("long streaks along {}: cells are twice as long along them; "
                      "a streak ends after about the length of the picture",
                      nameOf(grain)));
    }
    result.noise = std::move(bake.noise);
    result.tables = std::move(bake.tables);
    return result;
  }

  [[nodiscard]] Result<Json> measure(const Bundle& bundle, std::span<const MapExemplar> maps,
                                     const MethodBake& bake) const override {
    const Result<PrecisionLoss> loss =
        precisionLoss(bundle, 0, 0, maps.front(), !bake.bordersWereBlended);
    if (!loss)
      return loss.error();
    return Json{{"precisionLoss", asJson(loss.value())}};
  }
};

// ---- use of a noise ----

class Use final : public UseOptions {
public:
  std::optional<double> sharpness;
  std::optional<std::uint32_t> tileRotation;
  bool nearestTableLevel = false;

  void replace(MaterialNoise& material, EvaluationOptions& chosen) const override {
    material.blendSharpness = sharpness.value_or(material.blendSharpness);
    material.tileRotation = tileRotation.value_or(material.tileRotation);
    chosen.nearestTableLevel = nearestTableLevel;
  }
};

std::unique_ptr<Use> addUseOptions(CLI::App& verb) {
  auto options = std::make_unique<Use>();
  addValue(verb, "--sharpness", options->sharpness, optional(number(kBlendSharpnessRange)), "",
           "Exponent of the blend weights [default: the bundle's]")
      .group(kHeading);
  const Choices<std::uint32_t> rotations{{"none", 0}, {"2", 2}, {"4", 4}};
  addValue(verb, "--tile-rotation", options->tileRotation, optional(oneOf(rotations)), "",
           "Random rotation of each tile: by half turns (2); of square tiles by quarter turns (4) "
           "[default: the bundle's]")
      .group(kHeading);
  return options;
}

// ---- inspect ----

/// Texture fetches of shaders_glsl/noise/tiling.glsl for one pixel of a map on one plane: three
/// taps, and one of the inverse table.
int fetchesOfTiling(const TilingMap& map) {
  constexpr int kTaps = 3;
  return tableKindOf(map) == TableKind::none ? kTaps : kTaps + 1;
}

} // namespace

std::unique_ptr<const BakeOptions> TilingCommand::addBakeOptions(CLI::App& verb,
                                                                 const CommonOptions&) const {
  auto options = std::make_unique<Bake>();
  TilingOptions& tiling = options->options;
  const Choices<TransportEffort> efforts{{"fast", TransportEffort::fast},
                                         {"default", TransportEffort::standard}};
  addValue(verb, "--transport", tiling.transport, oneOf(efforts), "default",
           "Quality of the colour matching (optimal transport)")
      .group(kHeading);
  const Choices<GaussianOnly> gaussian{
      {"auto", GaussianOnly::detect}, {"yes", GaussianOnly::yes}, {"no", GaussianOnly::no}};
  addValue(verb, "--gaussian", tiling.gaussian, oneOf(gaussian), "auto",
           "Omit the inverse table; auto omits it if the values are Gaussian")
      .group(kHeading);
  return options;
}

std::unique_ptr<const UseOptions> TilingCommand::addSynthOptions(CLI::App& verb) const {
  std::unique_ptr<Use> options = addUseOptions(verb);
  addValue(verb, "--table-levels", options->nearestTableLevel,
           oneOf(Choices<bool>{{"blended", false}, {"nearest", true}}), "blended",
           "Mip levels of the inverse table: blend two, or fetch the nearest")
      .group(kHeading);
  return options;
}

std::unique_ptr<const UseOptions> TilingCommand::addApplyOptions(CLI::App& verb) const {
  return addUseOptions(verb);
}

void TilingCommand::describe(const Noise& noise, Json& json) const {
  if (const Grain grain = noise.as<TilingNoise>().grain; grain != Grain::none)
    json["grain"] = nameOf(grain);
}

std::vector<std::string> TilingCommand::linesOf(const Noise& noise,
                                                const MaterialNoise& use) const {
  const Grain grain = noise.as<TilingNoise>().grain;
  if (grain == Grain::none)
    return {};
  return {fmt::format("grain along {}{}", nameOf(grain),
                      use.tileRotation > 1 ? ", unused with tile rotation" : "")};
}

void TilingCommand::describe(const Bundle&, const NoiseMap& map, Json& json) const {
  const auto& tiling = map.as<TilingMap>();
  json["gaussian"] = tiling.gaussian;
  json["inverseTable"] = tiling.inverseTable ? Json(*tiling.inverseTable) : Json();
  json["table"] = nameOf(tableKindOf(tiling));
  json["dimensions"] = tiling.dimensions;
}

std::vector<std::string> TilingCommand::linesOf(const Bundle& bundle, const NoiseMap& map) const {
  const auto& tiling = map.as<TilingMap>();
  return {fmt::format("Gaussian image: table {}", tiling.gaussian),
          inverseTableWords(tiling.inverseTable, tiling.dimensions, bundle.tables)};
}

int TilingCommand::fetches(const Bundle&, const Noise&, const NoiseMap& map,
                           const MaterialNoise&) const {
  return fetchesOfTiling(map.as<TilingMap>());
}

const Table& TilingCommand::imageOf(const Bundle& bundle, const NoiseMap& map) const {
  return bundle.tables[map.as<TilingMap>().gaussian];
}

} // namespace lichen::cli
