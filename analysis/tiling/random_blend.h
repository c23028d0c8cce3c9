// SPDX-License-Identifier: MIT
// Weights of the three taps of a blend at a random point of the lattice.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace lichen::tiling {

/// [HN18] eq. 8 at a point uniform in the triangle, from two words of a hash. The squares of the
/// weights sum to 1.
[[nodiscard]] inline std::array<float, 3> randomBlendWeights(std::uint32_t first,
                                                             std::uint32_t second) {
  const auto random = [](std::uint32_t hash) { return float(hash >> 8u) * 0x1.0p-24f; };
  float a = random(first);
  float b = random(second);
  if (a + b > 1.0f) {
    a = 1.0f - a;
    b = 1.0f - b;
  }
  const float c = 1.0f - a - b;
  const float norm = std::sqrt(a * a + b * b + c * c);
  return {a / norm, b / norm, c / norm};
}

} // namespace lichen::tiling
