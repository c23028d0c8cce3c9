// SPDX-License-Identifier: MIT
// The Gaussian texture that spot noise on the pixels of Z^2 or of a torus converges to.
//
// The spot h is a texton of order 0: coefficient (i, j) is the value at that pixel of Z^2. The
// white noise is the same for all channels of a spot. This function may throw std::bad_alloc. The
// bytes do not depend on the number of threads.
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

/// Returns the additive Gaussian spot noise ADSN(h), or the circular CADSN(h) on a periodic domain:
/// the limit of spot noise for a high intensity, h convolved with Gaussian white noise. Mean 0,
/// covariance h * h~. [GLM14] section 2.
/// A pixel of white noise depends only on the seed and its position, so noises on two domains agree
/// where they overlap. A periodic noise agrees with them except in its first (spot width - 1)
/// columns and (spot height - 1) rows. On a torus smaller than the spot, the spot wraps.
[[nodiscard]] NoisePlanes gaussianSpotNoise(const Spot& spot, const PixelDomain& domain,
                                            std::uint64_t seed);

} // namespace lichen::gaussian
