// SPDX-License-Identifier: MIT
// The supported mappings of texton noise, the size of its exemplar, and its members as JSON.
#include "texton_format.h"

namespace lichen {

using Json = nlohmann::ordered_json;

bool TextonFormat::fits(Mapping mapping) const { return mapping != Mapping::solid; }

std::span<const std::string_view> TextonFormat::tableMembers() const {
  static constexpr std::array<std::string_view, 1> kMembers{"texton"};
  return kMembers;
}

bool TextonFormat::isMix(const Noise& noise) const { return noise.as<TextonShape>().steps > 1; }

void TextonFormat::writeNoise(const Noise& noise, Json& json) const {
  const auto& shape = noise.as<TextonShape>();
  json["texton"] = {{"coefficients", {shape.coefficientsX, shape.coefficientsY}},
                    {"order", shape.order},
                    {"mipLevels", shape.mipLevels},
                    {"texelsPerTile", {shape.texelsPerTileX, shape.texelsPerTileY}},
                    {"steps", shape.steps}};
}

void TextonFormat::writeMap(const NoiseMap& map, Json& json) const {
  const auto& texton = map.as<TextonMap>();
  json["texton"] = texton.image;
  json["scale"] = texton.scale;
  json["mipLoss"] = texton.mipLoss;
  for (const TextonStep& step : texton.laterSteps)
    json["laterSteps"].push_back(
        {{"mean", step.mean}, {"covariance", step.covariance}, {"mipLoss", step.mipLoss}});
}

std::array<std::uint32_t, 2> TextonFormat::exemplarSize(const Bundle& bundle, const Noise& noise,
                                                        const NoiseMap&) const {
  return tileSize(bundle, noise);
}

std::array<std::uint32_t, 2> TextonFormat::tileSize(const Bundle&, const Noise& noise) const {
  const auto& shape = noise.as<TextonShape>();
  return {std::uint32_t(shape.texelsPerTileX), std::uint32_t(shape.texelsPerTileY)};
}

} // namespace lichen
