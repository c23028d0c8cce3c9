// SPDX-License-Identifier: MIT
// How many impacts a texton needs: how much the magnitudes of its texels differ.
#pragma once

#include "fit.h"

#include <lichen/exemplar.h>

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

} // namespace lichen::texton
