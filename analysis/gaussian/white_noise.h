// SPDX-License-Identifier: MIT
// Random fields on Z^2 with independent pixels, the input of spot noises.
//
// A pixel's value depends only on the seed and its position, so fields on overlapping domains agree
// where they overlap, and any crop of the infinite field is available. Every field is width *
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

/// Returns a Poisson variate, exact to the resolution of a uniform number, 2^-53, in O(mean). It
/// depends only on mean, seed and counter. mean >= 0.
[[nodiscard]] int poissonVariate(double mean, std::uint64_t seed, std::uint64_t counter);

/// Returns the number of points on each pixel, for a Poisson process of `intensity` points per
/// pixel.
[[nodiscard]] std::vector<float> poissonCounts(const PixelDomain& domain, double intensity,
                                               std::uint64_t seed);

/// Returns normal deviates of mean 0 and variance 1.
[[nodiscard]] std::vector<float> gaussianWhiteNoise(const PixelDomain& domain, std::uint64_t seed);

} // namespace lichen::gaussian
