// SPDX-License-Identifier: MIT
// A random field on Z^2 with independent pixels, the input of spot noise.
//
// A pixel's value depends only on the seed and its position, so fields on overlapping domains agree
// where they overlap, and any crop of the infinite field is available. A field is width *
// height floats, row by row. The bytes do not depend on the number of threads.
#pragma once

#include <cstdint>
#include <vector>

namespace lichen::gaussian {

/// The pixels [x, x + width) x [y, y + height) of Z^2, sides at least 1.
struct PixelDomain {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
  /// Opposite borders meet: the domain is a torus, which the papers call circular.
  bool periodic = false;
};

/// Returns normal deviates of mean 0 and variance 1.
[[nodiscard]] std::vector<float> gaussianWhiteNoise(const PixelDomain& domain, std::uint64_t seed);

} // namespace lichen::gaussian
