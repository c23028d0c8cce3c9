// SPDX-License-Identifier: MIT
// The distance between two Gaussian textures.
#pragma once

#include "fit.h"

namespace lichen::texton {

/// Returns the Gaussian texture that the noise of a texton of this order converges to, on a torus
/// at least as large as the texton: h^ = sqrt(b^) alpha^, [GLM17] eq. 4. Frequency 0 is zero, as in
/// every model.
[[nodiscard]] gaussian::GaussianModel noiseModel(const TextonCoefficients& coefficients, int order,
                                                 int width, int height);

/// Returns the variance of a pixel, summed over the channels.
[[nodiscard]] double modelVariance(const gaussian::GaussianModel& model);

/// [GLM14] eq. 1: the squared L2 optimal transport distance between two Gaussian textures of one
/// size and number of channels, divided by the number of pixels. It is 0 where power spectra and
/// cross-spectra are equal, and at most the sum of the two variances. On any smaller domain the
/// distance between the textures is not larger (section 2.3).
[[nodiscard]] double squaredTransportDistance(const gaussian::GaussianModel& a,
                                              const gaussian::GaussianModel& b);

} // namespace lichen::texton
