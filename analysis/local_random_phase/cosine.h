// SPDX-License-Identifier: MIT
// What a vertex draws for a cosine, and the functions that a pixel evaluates: the CPU twins of
// those in shaders_glsl/noise/local_random_phase.glsl.
#pragma once

#include <cmath>
#include <cstdint>

namespace lichen::local_random_phase {

/// The random numbers of one cosine at one vertex.
struct Draw {
  std::uint32_t column = 0, row = 0; ///< of the rectangle of frequencies, [0, 1024)
  std::uint32_t variant = 0;
  float phase = 0.0f; ///< turns, [-1/2, 1/2]
};

/// As lichenCosinesGaussian draws. `variants` is a power of two, at most 32.
inline Draw nextDraw(std::uint32_t& state, std::uint32_t variants) {
  // The generator of pcg without its output function. The phase has the high bits, which are the
  // most random.
  state = state * 747796405u + 2891336453u;
  return {(state >> 1u) & 1023u, (state >> 11u) & 1023u, (state >> 21u) & (variants - 1u),
          float(std::int32_t(state)) * 0x1p-32f};
}

/// lichenCosineOfTurns: cos(2 pi turns), within 1.1e-4.
inline float cosineOfTurns(float turns) {
  const float z = 0.25f - std::abs(turns - std::floor(turns + 0.5f));
  const float square = z * z;
  return z * (6.2812805f + square * (-41.0952f + square * 73.5855f));
}

/// lichenCosineRetained: the amplitude that a footprint leaves of a cosine, for the square of the
/// cycles that it spans. The mean of a cosine over x cycles is sinc x, 1 - pi^2 x^2 / 6 near 0, as
/// this is.
inline float retainedAt(float squaredCycles) {
  constexpr float kSlope = 0.548311356f; // pi^2 / 18
  const float left = std::fmax(1.0f - kSlope * std::fmax(squaredCycles, 0.0f), 0.0f);
  return left * left * left;
}

} // namespace lichen::local_random_phase
