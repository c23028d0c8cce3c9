// SPDX-License-Identifier: MIT
// Weights of the three taps of a blend at a random point of the lattice, and positions for taps.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace lichen::gaussianization {

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

/// Position `k` of `count` that are spread evenly over the unit square: a lattice of the golden
/// ratio.
[[nodiscard]] inline std::array<float, 2> spreadPosition(std::uint32_t k, std::uint32_t count) {
  constexpr double kGoldenRatio = 0.61803398874989485;
  const double turns = kGoldenRatio * k;
  return {(float(k) + 0.5f) / float(count), float(turns - std::floor(turns))};
}

} // namespace lichen::gaussianization
