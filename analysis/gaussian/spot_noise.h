// SPDX-License-Identifier: MIT
// Spot noise on the pixels of Z^2 or of a torus, and the Gaussian texture that it tends to.
//
// The spot h is a texton of order 0: coefficient (i, j) is the value at that pixel of Z^2. Points
// have random places, all channels of a spot the same. Building blocks: std::bad_alloc passes
// through them. Same bytes for any number of threads. Source: [GLM14] section 2.
#pragma once

#include "spot.h"
#include "white_noise.h"

#include <cstdint>
#include <vector>

namespace lichen::gaussian {

/// A texture on a domain: (x, y, c) at (c * height + y) * width + x.
struct NoisePlanes {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<float> values;
};

/// How a convolution with the spot is computed; the results differ by rounding.
enum class Summation {
  direct,   ///< point by point: O(impacts a pixel * pixels)
  spectral, ///< by Fourier transforms: O(pixels * log(pixels)), for any intensity
};

/// The discrete spot noise DSN(h), or the circular CDSN(h) on a periodic domain:
/// (sum_i h(x - x_i) - intensity sum h) / sqrt(intensity), the x_i points of a Poisson process of
/// `intensity` > 0 points a pixel. Mean 0, covariance h * h~, excess kurtosis
/// sum h^4 / (intensity (sum h^2)^2). [GLM14] algorithm 1.
/// A point's place depends on the seed and the pixel alone, so noises on two domains agree where
/// they overlap; a periodic one agrees with them but for its first width - 1 columns and height - 1
/// rows, those of the spot. On a torus smaller than the spot the spot wraps.
[[nodiscard]] NoisePlanes discreteSpotNoise(const Spot& spot, double intensity,
                                            const PixelDomain& domain, std::uint64_t seed,
                                            Summation summation);

/// Its limit for a high intensity, ADSN(h), or CADSN(h) on a periodic domain: h convolved with
/// Gaussian white noise. Mean 0, covariance h * h~. Domains agree as above.
[[nodiscard]] NoisePlanes gaussianSpotNoise(const Spot& spot, const PixelDomain& domain,
                                            std::uint64_t seed);

} // namespace lichen::gaussian
