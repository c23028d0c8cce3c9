// SPDX-License-Identifier: MIT
// What a vertex draws for a cosine, and the functions that a pixel evaluates: the CPU twins of
// those in shaders_glsl/noise/local_random_phase.glsl.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace lichen::local_random_phase {

/// The variant that a vertex takes of all its cosines. `variants` is a power of two, at most 32.
inline std::uint32_t variantOf(std::uint32_t state, std::uint32_t variants) {
  return (state >> 27u) & (variants - 1u);
}

/// The random numbers of one cosine at one vertex.
struct Draw {
  float column = 0.0f, row = 0.0f; ///< from the middle of the rectangle, [-1/2, 1/2] of its sides
  float phase = 0.0f;              ///< turns, [-1/2, 1/2]
};

/// As lichenCosinesGaussian draws.
inline Draw nextDraw(std::uint32_t& state) {
  // The generator of pcg without its output function. The phase has the high bits, which are the
  // most random.
  state = state * 747796405u + 2891336453u;
  const auto share = [](std::uint32_t bits) { return float(std::int32_t(bits)) * 0x1p-32f; };
  return {share(state << 21u), share(state << 11u), share(state)};
}

/// lichenBeyondTexel: a squared length [texels^2] -> what is averaged beyond a texel, over which
/// the exemplar has averaged already: 0 up to 1, and soon all of it.
inline float beyondTexel(float squared) {
  const float own = std::max(squared, 1.0f);
  return own - 1.0f / (own * own * own);
}

/// The mean square frequency of a window along one axis [cycles^2 / edge^2]: a cosine under it has
/// that beside its own, so even one of frequency 0 is lost to wide pixels. By quadrature,
/// integral (dv/dx)^2 / (4 pi^2 integral v^2) of the normalised window v.
inline constexpr float kWindowSpread = 0.1733f;

/// lichenCosineOfTurns: cos(2 pi turns), within 1.1e-4.
inline float cosineOfTurns(float turns) {
  const float z = 0.25f - std::abs(turns - std::nearbyint(turns));
  const float square = z * z;
  return z * (6.2812805f + square * (-41.0952f + square * 73.5855f));
}

/// lichenCosineRetained: the amplitude that a footprint leaves of a cosine, for the square of the
/// cycles that it spans. The mean of a cosine over x cycles is sinc x, 1 - pi^2 x^2 / 6 near 0, as
/// this is.
inline float retainedAt(float squaredCycles) {
  constexpr float kSlope = 0.548311356f; // pi^2 / 18
  // Slanted pixels can be so long that the form is below 0 by rounding.
  const float left = std::clamp(1.0f - kSlope * squaredCycles, 0.0f, 1.0f);
  return left * left * left;
}

} // namespace lichen::local_random_phase
