// SPDX-License-Identifier: MIT
// The spots that [GLM14] compares its texton with, all textons of order 0.
//
// Each is a kernel of the model cut to a support of width x height pixels, in [1, the model's];
// whole, the circular Gaussian texture of each is the model's own. Source: [GLM14] section 4.
#pragma once

#include "gaussian_model.h"
#include "spot.h"

#include <cstdint>

namespace lichen::gaussian {

/// The exemplar itself less its mean, over the root of the support's pixels, from its first pixel
/// on: whole, t_u of [GLM14] eq. 3.
[[nodiscard]] Spot exemplarKernel(const GaussianModel& model, int width, int height);

/// The luminance texton: of each channel the phase of the mean of the channels is taken away, so
/// that energy gathers at the origin, which is pixel (width / 2, height / 2). Of one channel it is
/// the canonical texton, whose spectrum is positive. [DMR12].
[[nodiscard]] Spot luminanceTexton(const GaussianModel& model, int width, int height);

/// Part of a random-phase texture of the model, over the root of the support's pixels: what
/// algorithm 2 starts from, but as strong as the model. The paper cuts without the change of scale;
/// its error is then near 1 whatever the part is like (0.95 for 31 x 31 of 512 x 512).
[[nodiscard]] Spot randomPhaseKernel(const GaussianModel& model, int width, int height,
                                     std::uint32_t seed);

} // namespace lichen::gaussian
