// SPDX-License-Identifier: MIT
// The supported mappings of quilting, the size of its exemplars, and its members as JSON.
#include "quilting_format.h"

#include "methods/grain_member.h"

#include <algorithm>

namespace lichen {

using Json = nlohmann::ordered_json;

bool QuiltingFormat::fits(Mapping mapping) const {
  return mapping == Mapping::uv || mapping == Mapping::triplanar;
}

std::span<const std::string_view> QuiltingFormat::tableMembers() const {
  static constexpr std::array<std::string_view, 2> kMembers{"image", "cells"};
  return kMembers;
}

void QuiltingFormat::writeNoise(const Noise& noise, Json& json) const {
  const auto& shared = noise.as<QuiltingNoise>();
  writeGrain(shared.grain, json);
  json["reach"] = shared.reach;
  if (shared.correlation > 0.0)
    json["correlation"] = shared.correlation;
  if (!shared.offsets.empty())
    json["offsets"] = shared.offsets;
}

void QuiltingFormat::writeMap(const NoiseMap& map, Json& json) const {
  const auto& own = map.as<QuiltingMap>();
  json["image"] = own.image;
  json["cells"] = own.cells;
}

std::array<std::uint32_t, 2> QuiltingFormat::exemplarSize(const Bundle& bundle, const Noise&,
                                                          const NoiseMap& map) const {
  const Table& image = bundle.tables[map.as<QuiltingMap>().image];
  return {image.width, image.height};
}

std::array<std::uint32_t, 2> QuiltingFormat::tileSize(const Bundle& bundle,
                                                      const Noise& noise) const {
  std::array<std::uint32_t, 2> size{1, 1};
  for (const NoiseMap& map : noise.maps) {
    const auto [width, height] = exemplarSize(bundle, noise, map);
    size = {std::max(size[0], width), std::max(size[1], height)};
  }
  return size;
}

} // namespace lichen
