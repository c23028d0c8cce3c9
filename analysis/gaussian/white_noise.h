// SPDX-License-Identifier: MIT
// Random fields on Z^2 whose pixels are independent: what noises are convolutions of.
//
// A pixel's value depends on the seed and on where it lies alone, so that fields on overlapping
// domains agree where they overlap: any crop of the infinite field can be had. Every domain is
// width * height floats, row by row. Same bytes for any number of threads.
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
  /// Opposite borders meet: the domain is the torus that the papers call circular.
  bool periodic = false;
};

/// A Poisson variate: exact to the resolution of a uniform number, 2^-53, in O(mean). The same for
/// the same seed and counter. mean >= 0.
[[nodiscard]] int poissonVariate(double mean, std::uint64_t seed, std::uint64_t counter);

/// How many points of a Poisson process of `intensity` points a pixel fall on each pixel.
[[nodiscard]] std::vector<float> poissonCounts(const PixelDomain& domain, double intensity,
                                               std::uint64_t seed);

/// Normal deviates of mean 0 and variance 1.
[[nodiscard]] std::vector<float> gaussianWhiteNoise(const PixelDomain& domain, std::uint64_t seed);

} // namespace lichen::gaussian
