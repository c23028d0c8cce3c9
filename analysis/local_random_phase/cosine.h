// SPDX-License-Identifier: MIT
// What a vertex draws for a cosine: the CPU twin of lichenAddCosine
// (shaders_glsl/noise/local_random_phase.glsl).
#pragma once

#include "sampling/wave.h"

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

/// The mean square frequency of a window along one axis [cycles^2 / edge^2]: a cosine under it has
/// that beside its own, so even one of frequency 0 is lost to wide pixels. By quadrature,
/// integral (dv/dx)^2 / (4 pi^2 integral v^2) of the normalised window v.
inline constexpr float kWindowSpread = 0.1733f;

} // namespace lichen::local_random_phase
