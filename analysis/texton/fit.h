// SPDX-License-Identifier: MIT
// Fits the coefficients of a texton to a given noise spectrum.
#pragma once

#include "gaussian_model.h"
#include "progress_part.h"

#include <cstdint>
#include <vector>

namespace lichen::texton {

struct FitOptions {
  int width = 0;  ///< coefficients, [1, the model's width]
  int height = 0; ///< coefficients, [1, the model's height]
  int order = 1;  ///< order of the interpolating B-spline, [0, 8]
  std::uint32_t seed = 1;
  ProgressPart progress{}; ///< reports each iteration
};

/// Returns coefficients whose noise is close to the model. The border does not show, and no
/// coefficient stands out (docs/decisions/008-textons.md).
/// The bytes do not depend on the number of threads. Time: 100 transforms of a plane per channel.
/// Throws std::bad_alloc, and Interrupted where the caller stops the fit.
[[nodiscard]] TextonCoefficients fitCoefficients(const GaussianModel& model,
                                                 const FitOptions& options);

/// [GLM14] eq. 5: the transport distance between the two Gaussian textures over the model's
/// standard deviation, without frequency 0. 0 for equal power spectra, 1 for a texton of zeros.
[[nodiscard]] double relativeModelError(const GaussianModel& model,
                                        const TextonCoefficients& coefficients, int order);

struct ModelErrors {
  double all = 0.0;             ///< relativeModelError()
  std::vector<double> channels; ///< the same of each channel alone
};

[[nodiscard]] ModelErrors modelErrors(const GaussianModel& model,
                                      const TextonCoefficients& coefficients, int order);

} // namespace lichen::texton
