// SPDX-License-Identifier: MIT
// Pictures for the error rates of quilting: materials with a structure, which it must find,
// and materials without. No threshold may be chosen with them; tests/exemplars/structured.h is for
// that.
//
// Each picture has its own seed, side, colours, sizes and contrast.
#pragma once

#include <lichen/image.h>

#include <string>

namespace lichen::test {

inline constexpr int kStructuredHeldBack = 110, kStochasticHeldBack = 110;    // pictures
inline constexpr int kSmallestQuiltingSide = 180, kLargestQuiltingSide = 204; // pixels

struct HeldBackPicture {
  std::string name; ///< kind, condition
  SrgbImage image;  ///< square, RGB, 8 bits
};

/// Eleven kinds in ten conditions. `index` is in [0, kStructuredHeldBack).
[[nodiscard]] HeldBackPicture structuredHeldBack(int index);

/// Ten kinds, eleven pictures of each. `index` is in [0, kStochasticHeldBack).
[[nodiscard]] HeldBackPicture stochasticHeldBack(int index);

} // namespace lichen::test
