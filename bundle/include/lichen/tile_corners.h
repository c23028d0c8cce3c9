// SPDX-License-Identifier: MIT
// The part of a picture that is made the tile, as its four corners.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace lichen {

/// Upper left, upper right, lower right and lower left. [pixels], y down; (0, 0) is the outer
/// corner of the first pixel.
using TileCorners = std::array<std::array<double, 2>, 4>;

/// Whether they go around a convex quadrilateral in that order, which a square seen in perspective
/// is.
[[nodiscard]] inline bool areConvex(const TileCorners& corners) {
  bool convex = true;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto& [x, y] = corners[k];
    const auto& [nextX, nextY] = corners[(k + 1) % 4];
    const auto& [lastX, lastY] = corners[(k + 3) % 4];
    convex = convex && (nextX - x) * (lastY - y) - (nextY - y) * (lastX - x) > 0.0;
  }
  return convex;
}

/// The mean lengths of the horizontal and of the vertical sides.
[[nodiscard]] inline std::array<double, 2> meanSides(const TileCorners& corners) {
  const auto length = [&](std::size_t a, std::size_t b) {
    return std::hypot(corners[b][0] - corners[a][0], corners[b][1] - corners[a][1]);
  };
  return {0.5 * (length(0, 1) + length(3, 2)), 0.5 * (length(0, 3) + length(1, 2))};
}

} // namespace lichen
