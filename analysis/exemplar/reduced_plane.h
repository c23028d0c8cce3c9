// SPDX-License-Identifier: MIT
// A map as one small grey plane, for measures of what shows from some distance.
#pragma once

#include <lichen/exemplar.h>

#include <cstddef>
#include <vector>

namespace lichen::exemplar {

/// width x height values about their mean, row 0 at the top.
struct Plane {
  int width = 0, height = 0;
  std::vector<float> values;

  [[nodiscard]] float at(int x, int y) const {
    return values[std::size_t(y) * std::size_t(width) + std::size_t(x)];
  }
};

/// Averages squares of pixels, and all channels, so that the shorter side has `side` to 2 * side -
/// 1 values, or as many as the map has pixels if those are fewer. Throws std::bad_alloc.
[[nodiscard]] Plane reducedPlane(const MapExemplar& map, int side);

} // namespace lichen::exemplar
