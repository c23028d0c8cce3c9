// SPDX-License-Identifier: MIT
// The members of a tiling noise and of its maps as JSON.
#include "method_writer.h"

namespace lichen {
namespace {

using Json = nlohmann::ordered_json;

void writeNoise(const Noise& noise, Json& json) {
  if (const Grain grain = noise.as<TilingNoise>().grain; grain != Grain::none)
    json["grain"] = nameOf(grain);
}

void writeMap(const NoiseMap& map, Json& json) {
  const auto& tiling = map.as<TilingMap>();
  json["dimensions"] = tiling.dimensions;
  json["gaussian"] = tiling.gaussian;
  if (tiling.inverseTable)
    json["inverseTable"] = *tiling.inverseTable;
}

} // namespace

extern const MethodWriter kTilingWriter{writeNoise, writeMap};

} // namespace lichen
