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
  constexpr float kMostSlant = 16.0f;
  const float squared = std::max({1.0f, x[0] * x[0] + x[1] * x[1], y[0] * y[0] + y[1] * y[1]});
  const float area = std::abs(x[0] * y[1] - x[1] * y[0]);
  return 0.25f * std::log2(squared * std::max({area, std::sqrt(squared), squared / kMostSlant}));
}

float sharpLevel(float footprintLevel) {
  return std::max(0.5f * footprintLevel, footprintLevel - 0.5f);
}

} // namespace lichen
