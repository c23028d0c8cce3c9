// SPDX-License-Identifier: MIT
#include "footprint_level.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lichen {

float footprintLevel(const TileFootprint& at, float texelsPerTileX, float texelsPerTileY) {
  using Vec2 = std::array<float, 2>;
  const Vec2 x{at.dx[0] * texelsPerTileX, at.dx[1] * texelsPerTileY};
  const Vec2 y{at.dy[0] * texelsPerTileX, at.dy[1] * texelsPerTileY};
  constexpr float kLeast = 1e-20f; // texels^2; keeps log2 defined for a zero footprint
  const float squared = std::max({kLeast, x[0] * x[0] + x[1] * x[1], y[0] * y[0] + y[1] * y[1]});
  const float longer = 0.5f * std::log2(squared);
  if (longer <= 0.0f)
    return longer;
  constexpr float kMostSlant = 16.0f;
  const float area = std::abs(x[0] * y[1] - x[1] * y[0]);
  const float slant = std::min(squared / std::max(area, std::sqrt(squared)), kMostSlant);
  const float lambda = longer - 0.25f * std::log2(slant);
  return std::max(0.5f * lambda, lambda - 0.5f); // lichenSharpLevel
}

} // namespace lichen
