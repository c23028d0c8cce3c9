// SPDX-License-Identifier: MIT
// What a synthesis-oriented texton is worth beside the other spots of its support.
#pragma once

#include "fit.h"

#include <lichen/texton_comparison.h>

#include <cstdint>
#include <span>
#include <vector>

namespace lichen::texton {

/// r^2 sum l^4 / (sum l^2)^2 over the support's r^2 pixels, l the channels' sum weighted by
/// `weights`, one a channel: 1 for a spot of one magnitude, 3 for values normally distributed, r^2
/// for a spot of one pixel. 0 for a spot of zeros.
[[nodiscard]] double flatness(const TextonCoefficients& spot, std::span<const float> weights);

/// The interpolated texton at the places of its coefficients and around them: they themselves up to
/// order 1, their cubic B-spline for order 3, whose coefficients may be far larger than what they
/// make.
[[nodiscard]] TextonCoefficients interpolatedSpot(const TextonCoefficients& coefficients,
                                                  int order);

/// What an eye takes a texel of these channels for: weights of its luminance, or of their sum.
[[nodiscard]] std::vector<float> seenWeights(std::span<const MapChannel> channels);

/// The texton beside spots of as many coefficients, all interpolated by the B-spline of `order` and
/// all with the model's covariance: without it the nearest spot has less variance than the model.
/// `weights` as for flatness, `seed` that of the random phases. Same bytes for any number of
/// threads.
[[nodiscard]] KernelComparison compareKernels(const gaussian::GaussianModel& model,
                                              const TextonCoefficients& texton, int order,
                                              std::span<const float> weights,
                                              std::uint32_t seed = 1);

} // namespace lichen::texton
