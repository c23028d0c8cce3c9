// SPDX-License-Identifier: MIT
// Map -> small grey plane.
#include "reduced_plane.h"

#include <algorithm>

namespace lichen::exemplar {

Plane reducedPlane(const MapExemplar& map, int side) {
  const int square = std::max(1, std::min(map.width, map.height) / side);
  const auto channels = int(map.channels.size());
  Plane plane{map.width / square, map.height / square, {}};
  plane.values.reserve(std::size_t(plane.width) * std::size_t(plane.height));
  double sum = 0.0;
  for (int y = 0; y < plane.height; ++y)
    for (int x = 0; x < plane.width; ++x) {
      float total = 0.0f;
      for (int dy = 0; dy < square; ++dy) {
        const std::size_t row = std::size_t(y * square + dy) * std::size_t(map.width);
        const auto* begin = &map.values[(row + std::size_t(x * square)) * std::size_t(channels)];
        for (int k = 0; k < square * channels; ++k)
          total += begin[k];
      }
      plane.values.push_back(total / float(square * square * channels));
      sum += double(plane.values.back());
    }
  const auto mean = float(sum / double(plane.values.size()));
  for (float& value : plane.values)
    value -= mean;
  return plane;
}

} // namespace lichen::exemplar
