// SPDX-License-Identifier: MIT
// The supported mappings of tiling, the size of its exemplars, and its members as JSON.
#include "tiling_format.h"

#include "methods/grain_member.h"

#include <algorithm>

namespace lichen {

using Json = nlohmann::ordered_json;

bool TilingFormat::fits(Mapping mapping) const {
  return mapping == Mapping::uv || mapping == Mapping::triplanar;
}

std::span<const std::string_view> TilingFormat::tableMembers() const {
  static constexpr std::array<std::string_view, 2> kMembers{"gaussian", "inverseTable"};
  return kMembers;
}

void TilingFormat::writeNoise(const Noise& noise, Json& json) const {
  writeGrain(noise.as<TilingNoise>().grain, json);
}

void TilingFormat::writeMap(const NoiseMap& map, Json& json) const {
  const auto& tiling = map.as<TilingMap>();
  json["dimensions"] = tiling.dimensions;
  json["gaussian"] = tiling.gaussian;
  if (tiling.inverseTable)
    json["inverseTable"] = *tiling.inverseTable;
}

std::array<std::uint32_t, 2> TilingFormat::exemplarSize(const Bundle& bundle, const Noise&,
                                                        const NoiseMap& map) const {
  const Table& gaussian = bundle.tables[map.as<TilingMap>().gaussian];
  return {gaussian.width, gaussian.height};
}

std::array<std::uint32_t, 2> TilingFormat::tileSize(const Bundle& bundle,
                                                    const Noise& noise) const {
  std::array<std::uint32_t, 2> size{1, 1};
  for (const NoiseMap& map : noise.maps) {
    const auto [width, height] = exemplarSize(bundle, noise, map);
    size = {std::max(size[0], width), std::max(size[1], height)};
  }
  return size;
}

TableKind tableKindOf(const TilingMap& map) {
  return map.inverseTable ? TableKind::joint : TableKind::none;
}

std::string_view nameOf(TableKind kind) {
  constexpr std::array<std::string_view, 2> kNames = {"joint", "none"};
  return kNames[std::size_t(kind)];
}

} // namespace lichen
