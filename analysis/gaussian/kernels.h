// SPDX-License-Identifier: MIT
// The spots that [GLM14] compares its texton with; all are textons of order 0.
//
// Each is a kernel of the model, cut to a support of width x height pixels, in [1, the model's].
// Uncut, the circular Gaussian texture of each is the model's own. Source: [GLM14] section 4.
#pragma once

#include "gaussian_model.h"
#include "spot.h"

#include <cstdint>

namespace lichen::gaussian {

/// Returns the exemplar minus its mean, over the square root of the support's pixel count, starting
/// at its first pixel. Uncut, this is t_u of [GLM14] eq. 3.
[[nodiscard]] Spot exemplarKernel(const GaussianModel& model, int width, int height);

/// Returns the luminance texton: subtracts from each channel the phase of the mean of the channels,
/// so that energy concentrates at the origin, pixel (width / 2, height / 2). For one channel this
/// is the canonical texton, whose spectrum is positive. [DMR12].
[[nodiscard]] Spot luminanceTexton(const GaussianModel& model, int width, int height);

/// Returns part of a random-phase texture of the model, over the square root of the support's pixel
/// count: the start of algorithm 2, but scaled to the model's variance. The paper cuts without this
/// scale, and its error is then near 1 whatever the part is (0.95 for 31 x 31 of 512 x 512).
[[nodiscard]] Spot randomPhaseKernel(const GaussianModel& model, int width, int height,
                                     std::uint32_t seed);

} // namespace lichen::gaussian
