// SPDX-License-Identifier: MIT
// Point and footprint -> the window of cells around the point.
#include "impacts.h"

#include "sampling/footprint_level.h"

#include <algorithm>

namespace lichen::texton {
namespace {

/// Returns a cell's index modulo 2^32, or in [0, period).
std::uint32_t wrapped(std::int64_t cell, std::int32_t period) {
  if (period == 0)
    return std::uint32_t(cell);
  const std::int64_t rest = cell % period;
  return std::uint32_t(rest < 0 ? rest + period : rest);
}

} // namespace

Reach mipReach(float level, const shader::LichenTextonNoise& texton) {
  const float side = std::exp2(std::ceil(level));
  const auto high = [&](int coefficients) {
    return (std::ceil(float(coefficients) / side) + 0.5f) * side;
  };
  return {{-0.5f * side, -0.5f * side}, {high(texton.coefficientsX), high(texton.coefficientsY)}};
}

Impacts impactsWithin(float margin, const TileFootprint& at, const shader::LichenMaterial& material,
                      const shader::LichenNoise& noise) {
  const Vec2 texelsPerTile{noise.tileTexelsX, noise.tileTexelsY};
  const Vec2 cellsPerTile{material.columnsPerTile, material.rowsPerTile};
  const Vec2 offset{material.offsetX, material.offsetY};
  const Vec2 coefficients{float(textonPart(noise).coefficientsX),
                          float(textonPart(noise).coefficientsY)};
  const std::array<std::int32_t, 2> origin{material.cellI, material.cellJ};
  const std::array<std::int32_t, 2> period{material.periodColumns, material.periodRows};
  Impacts impacts;
  impacts.footprintLevel = sharpLevel(footprintLevel(at, texelsPerTile[0], texelsPerTile[1]));
  impacts.level = std::min(impacts.footprintLevel, float(textonPart(noise).mipCount - 1));
  const Reach reach = mipReach(impacts.level, textonPart(noise));
  for (std::size_t k = 0; k < 2; ++k) {
    float low = reach.low[k];
    float high = reach.high[k];
    if (textonPart(noise).order == 3 && impacts.level < 1.0f) {
      constexpr float kReach = 1.5f; // reach of a cubic B-spline beyond its texel
      low = std::min(low, -kReach);
      high = std::max(high, coefficients[k] + kReach);
    }
    low -= margin * std::exp2(impacts.level);
    high += margin * std::exp2(impacts.level);
    impacts.middle[k] = 0.5f * (low + high);
    impacts.radius[k] = high - impacts.middle[k];
    // The centre of the coefficients lies at the impact's position.
    const float grid = (at.position[k] + offset[k]) * cellsPerTile[k];
    const float cell = std::floor(grid);
    const float inside = grid - cell;
    impacts.cellTexels[k] = texelsPerTile[k] / cellsPerTile[k];
    const float shift = 0.5f * coefficients[k] - impacts.middle[k];
    const float first = std::floor(inside + (shift - impacts.radius[k]) / impacts.cellTexels[k]);
    const float last = std::floor(inside + (shift + impacts.radius[k]) / impacts.cellTexels[k]);
    impacts.start[k] = shift + (inside - first) * impacts.cellTexels[k];
    // Half a cell beyond the last one, because the sums of cell sides are rounded.
    impacts.end[k] = impacts.start[k] - (last - first + 0.5f) * impacts.cellTexels[k];
    // 64 bits, because 2^28 tiles may have 2^47 cells.
    impacts.firstCell[k] = wrapped(std::int64_t(cell) + std::int64_t(first) + origin[k], period[k]);
  }
  return impacts;
}

} // namespace lichen::texton
