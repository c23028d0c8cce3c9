// SPDX-License-Identifier: MIT
// Spot noise on the pixels of Z^2 or of a torus, and the Gaussian texture that it converges to.
//
// The spot h is a texton of order 0: coefficient (i, j) is the value at that pixel of Z^2. Points
// have random positions, the same for all channels of a spot. These functions may throw
// std::bad_alloc. The bytes do not depend on the number of threads. Source: [GLM14] section 2.
#pragma once

#include "spot.h"
#include "white_noise.h"

#include <cstdint>
#include <vector>

namespace lichen::gaussian {

/// A texture on a domain: (x, y, c) is at (c * height + y) * width + x.
struct NoisePlanes {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<float> values;
};

/// How a convolution with the spot is computed. The results differ by rounding only.
enum class Summation {
  direct,   ///< point by point: O(impacts per pixel * pixels)
  spectral, ///< by Fourier transforms: O(pixels * log(pixels)), for any intensity
};

/// Returns the discrete spot noise DSN(h), or the circular CDSN(h) on a periodic domain: (sum_i h(x
/// - x_i) - intensity sum h) / sqrt(intensity), where x_i are the points of a Poisson process of
/// `intensity` > 0 points per pixel. Mean 0, covariance h * h~, excess kurtosis sum h^4 /
/// (intensity (sum h^2)^2). [GLM14] algorithm 1.
/// A point's position depends only on the seed and the pixel, so noises on two domains agree where
/// they overlap. A periodic noise agrees with them except in its first (spot width - 1) columns and
/// (spot height - 1) rows. On a torus smaller than the spot, the spot wraps.
[[nodiscard]] NoisePlanes discreteSpotNoise(const Spot& spot, double intensity,
                                            const PixelDomain& domain, std::uint64_t seed,
                                            Summation summation);

/// Returns the limit for a high intensity, ADSN(h), or CADSN(h) on a periodic domain: h convolved
/// with Gaussian white noise. Mean 0, covariance h * h~. Domains agree as for discreteSpotNoise().
[[nodiscard]] NoisePlanes gaussianSpotNoise(const Spot& spot, const PixelDomain& domain,
                                            std::uint64_t seed);

} // namespace lichen::gaussian
