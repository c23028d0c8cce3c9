// SPDX-License-Identifier: MIT
// Rotation steps -> cosine and sine -> rotated offsets and slopes.
#include "tile_rotation.h"

#include <cmath>
#include <numbers>

namespace lichen::tiling {

bool rotationsKeepTexels(std::uint32_t tileRotation, float tileAspect) {
  return tileRotation <= 2 || (tileRotation == 4 && tileAspect == 1.0f);
}

std::array<float, 2> tileRotationAt(std::uint32_t step, std::uint32_t steps) {
  const std::uint32_t quarter = (8 * step + steps) / (2 * steps); // the nearest one
  const double rest = 4.0 * double(step) - double(quarter) * double(steps);
  const double angle = 0.5 * std::numbers::pi * rest / double(steps);
  const auto cosine = float(std::cos(angle));
  const auto sine = float(std::sin(angle));
  const std::array<std::array<float, 2>, 4> turns{
      {{cosine, sine}, {-sine, cosine}, {-cosine, -sine}, {sine, -cosine}}};
  return turns[quarter % 4];
}

std::array<float, 2> turned(const std::array<float, 2>& way, const std::array<float, 2>& turn,
                            float aspect) {
  return {turn[0] * way[0] - turn[1] * way[1] / aspect,
          turn[0] * way[1] + turn[1] * way[0] * aspect};
}

std::array<float, 2> slopesRotatedBack(float slopeX, float slopeY,
                                       const std::array<float, 2>& turn) {
  return {turn[0] * slopeX - turn[1] * slopeY, turn[0] * slopeY + turn[1] * slopeX};
}

} // namespace lichen::tiling
