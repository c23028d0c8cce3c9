// SPDX-License-Identifier: MIT
// Compares a synthesis-oriented texton with other spots of the same support.
#pragma once

#include "fit.h"

#include <lichen/texton_comparison.h>

#include <cstdint>
#include <span>
#include <vector>

namespace lichen::texton {

/// Returns r^2 sum l^4 / (sum l^2)^2 over the r^2 pixels of the support, where l is the sum of the
/// channels with `weights`, one per channel. The value is 1 for a spot of constant magnitude, 3 for
/// normally distributed values, r^2 for a spot of one pixel and 0 for a spot of zeros.
[[nodiscard]] double flatness(const TextonCoefficients& spot, std::span<const float> weights);

/// Returns the interpolated texton at and around its coefficients. Up to order 1 these are the
/// coefficients; for order 3 they are the cubic B-spline, whose coefficients may be far larger than
/// its values.
[[nodiscard]] TextonCoefficients interpolatedSpot(const TextonCoefficients& coefficients,
                                                  int order);

/// Weights that approximate how the eye sees these channels: luminance weights for colours, else 1
/// each.
[[nodiscard]] std::vector<float> seenWeights(std::span<const MapChannel> channels);

/// Compares the texton with spots that have as many coefficients. All are interpolated with the
/// B-spline of `order` and have the model's covariance; without that correction the nearest spot
/// has less variance than the model. `weights` is as for flatness(); `seed` sets the random phases.
/// The bytes do not depend on the number of threads.
[[nodiscard]] KernelComparison compareKernels(const gaussian::GaussianModel& model,
                                              const TextonCoefficients& texton, int order,
                                              std::span<const float> weights,
                                              std::uint32_t seed = 1);

} // namespace lichen::texton
