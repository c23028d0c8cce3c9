// SPDX-License-Identifier: MIT
// Gaussian textures of a model at any size.
#pragma once

#include "gaussian_model.h"
#include "spot.h"
#include "spot_noise.h"

#include <cstdint>

namespace lichen::gaussian {

/// Returns the luminance texton of [GLM14] section 4: subtracts from each channel the phase of the
/// mean of the channels, so that energy concentrates at pixel (width / 2, height / 2). For one
/// channel this is the canonical texton, whose spectrum is positive. [DMR12].
[[nodiscard]] Spot luminanceTexton(const GaussianModel& model);

/// Returns a realization of the model on any domain, computed by transforms. It is exact on the
/// model's own torus and on planes no larger than it, which are parts of the torus.
/// On other domains it is the noise of the model's luminance texton, surrounded by zeros. The
/// covariance between the channels of a pixel is exact. The covariance at lags differs by what
/// wraps on the model's torus: at lags up to 16 pixels by about 1 % for photographs of 512 x 512,
/// and by 3 to 5 % for exemplars of 128 x 128.
[[nodiscard]] NoisePlanes gaussianTexture(const GaussianModel& model, const PixelDomain& domain,
                                          std::uint64_t seed);

} // namespace lichen::gaussian
