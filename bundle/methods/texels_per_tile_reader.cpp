// SPDX-License-Identifier: MIT
// texelsPerTile -> width and height.
#include "texels_per_tile_reader.h"

#include <cmath>

namespace lichen {

std::optional<std::array<int, 2>> readTexelsPerTile(ObjectReader& reader) {
  const auto values = reader.pair("texelsPerTile", {1.0, double(kMaxTableSide)});
  if (!values)
    return std::nullopt;
  for (const double value : *values)
    if (value != std::floor(value)) {
      reader.error("type", "texelsPerTile", nlohmann::json(value).dump() + "; expected an integer");
      return std::nullopt;
    }
  return std::array{int((*values)[0]), int((*values)[1])};
}

} // namespace lichen
