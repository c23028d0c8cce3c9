// SPDX-License-Identifier: MIT
// Pictures for the error rates of quilting: materials with a structure, which it must find,
// and materials without. No threshold may be chosen with them; exemplars/structured.h is for that.
//
// Each picture has its own seed, side, colours, sizes and contrast.
#pragma once

#include <lichen/image.h>

#include <array>
#include <string>
#include <structured.h>
#include <vector>

namespace lichen::test {

inline constexpr int kStructuredHeldBack = 110, kStochasticHeldBack = 110;    // pictures
inline constexpr int kSmallestQuiltingSide = 180, kLargestQuiltingSide = 204; // pixels

struct HeldBackPicture {
  std::string name; ///< kind, condition
  SrgbImage image;  ///< square, RGB, 8 bits
  /// cells[y * width + x] is the cell at the middle of the pixel, numbered from 0 by first
  /// appearance, or -1 for a joint. Empty for cloths and for materials without a structure.
  std::vector<int> cells;
  /// Two offsets after which the structure repeats, in pixels, measured at the middle of the
  /// picture. The second is 0 if there is only one, and both are if there is none.
  std::array<exemplars::Point, 2> periods;
};

/// Eleven kinds in ten conditions. `index` is in [0, kStructuredHeldBack).
[[nodiscard]] HeldBackPicture structuredHeldBack(int index);

/// Ten kinds, eleven pictures of each. `index` is in [0, kStochasticHeldBack).
[[nodiscard]] HeldBackPicture stochasticHeldBack(int index);

} // namespace lichen::test
