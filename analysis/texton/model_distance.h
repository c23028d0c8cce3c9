// SPDX-License-Identifier: MIT
// How far two Gaussian textures are from each other.
#pragma once

#include "fit.h"

namespace lichen::texton {

/// The Gaussian texture that the noise of a texton of this order tends to, on a torus of at least
/// the texton's size: h^ = sqrt(b^) alpha^, [GLM17] eq. 4; without frequency 0, as every model.
[[nodiscard]] gaussian::GaussianModel noiseModel(const TextonCoefficients& coefficients, int order,
                                                 int width, int height);

/// The variance of a pixel, summed over the channels.
[[nodiscard]] double modelVariance(const gaussian::GaussianModel& model);

/// [GLM14] eq. 1: the squared L2 optimal-transport distance between two Gaussian textures of one
/// size and number of channels, divided by the number of pixels; 0 where the power and the
/// cross-spectra are equal, at most the sum of the two variances. The same between the textures'
/// parts on any smaller domain is not larger (section 2.3).
[[nodiscard]] double squaredTransportDistance(const gaussian::GaussianModel& a,
                                              const gaussian::GaussianModel& b);

} // namespace lichen::texton
