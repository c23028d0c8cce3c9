// SPDX-License-Identifier: MIT
// Counter-based random numbers: the value depends only on (seed, counter), not on the order of
// calls.
#pragma once

#include "point.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace lichen::transport {

/// SplitMix64 [SLF14], applied to a counter.
[[nodiscard]] inline std::uint64_t randomBits(std::uint64_t seed, std::uint64_t counter) {
  std::uint64_t z = seed * 0xD1342543DE82EF95u + (counter + 1u) * 0x9E3779B97F4A7C15u;
  z = (z ^ (z >> 30u)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27u)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31u);
}

/// Uniform in [0, 1).
[[nodiscard]] inline double randomUniform(std::uint64_t seed, std::uint64_t counter) {
  return double(randomBits(seed, counter) >> 11u) * 0x1.0p-53;
}

/// A unit vector, uniform on the sphere (Archimedes' projection).
[[nodiscard]] inline Point randomDirection(std::uint64_t seed, std::uint64_t counter) {
  const double z = 2.0 * randomUniform(seed, 2 * counter) - 1.0;
  const double angle = 2.0 * std::numbers::pi * randomUniform(seed, 2 * counter + 1);
  const double radius = std::sqrt(std::max(0.0, 1.0 - z * z));
  return {float(radius * std::cos(angle)), float(radius * std::sin(angle)), float(z)};
}

} // namespace lichen::transport
