// SPDX-License-Identifier: MIT
// The supported mappings of local random-phase noise, the size of its exemplar, and its members as
// JSON.
#include "local_random_phase_format.h"

#include <lichen/bfloat16_pair.h>

#include <numeric>

namespace lichen {

using Json = nlohmann::ordered_json;

bool LocalRandomPhaseFormat::fits(Mapping mapping) const {
  return mapping == Mapping::uv || mapping == Mapping::triplanar;
}

std::span<const std::string_view> LocalRandomPhaseFormat::tableMembers() const {
  static constexpr std::array<std::string_view, 2> kMembers{"cosines", "inverseTable"};
  return kMembers;
}

void LocalRandomPhaseFormat::writeNoise(const Noise& noise, Json& json) const {
  const auto& shared = noise.as<LocalRandomPhaseNoise>();
  json["localRandomPhase"] = {{"texelsPerTile", {shared.texelsPerTileX, shared.texelsPerTileY}},
                              {"columns", shared.columns},
                              {"rows", shared.rows},
                              {"octaves", shared.cosines},
                              {"variants", shared.variants}};
}

void LocalRandomPhaseFormat::writeMap(const NoiseMap& map, Json& json) const {
  const auto& own = map.as<LocalRandomPhaseMap>();
  json["dimensions"] = own.dimensions;
  json["cosines"] = own.cosines;
  if (own.inverseTable)
    json["inverseTable"] = *own.inverseTable;
}

std::array<std::uint32_t, 2> LocalRandomPhaseFormat::exemplarSize(const Bundle& bundle,
                                                                  const Noise& noise,
                                                                  const NoiseMap&) const {
  return tileSize(bundle, noise);
}

std::array<std::uint32_t, 2> LocalRandomPhaseFormat::tileSize(const Bundle&,
                                                              const Noise& noise) const {
  const auto& shared = noise.as<LocalRandomPhaseNoise>();
  return {std::uint32_t(shared.texelsPerTileX), std::uint32_t(shared.texelsPerTileY)};
}

std::vector<std::array<CosineTexel, kRowCosines>> cosineTexels(const std::vector<float>& image) {
  std::vector<std::array<CosineTexel, kRowCosines>> texels(image.size() / 4);
  for (std::size_t i = 0; i < texels.size(); ++i)
    for (std::size_t j = 0; j < kRowCosines; ++j) {
      const auto [first, second] = fromBfloat16Pair(image[4 * i + 2 * j]);
      const auto [third, fourth] = fromBfloat16Pair(image[4 * i + 2 * j + 1]);
      texels[i][j] = {first, second, third, fourth};
    }
  return texels;
}

int LocalRandomPhaseNoise::cosineCount() const {
  return std::accumulate(cosines.begin(), cosines.end(), 0);
}

} // namespace lichen
