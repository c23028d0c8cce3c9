// SPDX-License-Identifier: MIT
// The coefficients of a texton from the spectrum that its noise is to have.
#pragma once

#include "gaussian/gaussian_model.h"
#include "gaussian/spot.h"

#include <cstdint>
#include <functional>

namespace lichen::texton {

/// The B-spline coefficients of a texton, `width` x `height` of them.
using TextonCoefficients = gaussian::Spot;

struct FitOptions {
  int width = 0;  ///< coefficients, [1, the model's width]
  int height = 0; ///< coefficients, [1, the model's height]
  int order = 1;  ///< of the interpolating B-spline, [0, 8]
  std::uint32_t seed = 1;
  int projections = 50; ///< of alternatingProjections, >= 1; 50 in [GLM17] section 4.2
  /// Called after each iteration; false ends the fit with what there is.
  std::function<bool()> goOn;
};

/// How the coefficients are found.
enum class FitMethod {
  transportDistance,      ///< least transport distance, from a start of relaxed reflections
  alternatingProjections, ///< [GLM17] algorithm 1 as printed; of order 0, [GLM14] algorithm 2
};

/// How many times a fit calls FitOptions::goOn.
[[nodiscard]] int iterationsOf(const FitOptions& options, FitMethod method);

/// Coefficients whose noise is near the model; by least transport distance their border does not
/// show and none stands out (docs/decisions/019-border-of-textons.md). Same bytes for any number of
/// threads. Time: 100 transforms of a plane for each channel. Throws std::bad_alloc.
[[nodiscard]] TextonCoefficients fitCoefficients(const gaussian::GaussianModel& model,
                                                 const FitOptions& options, FitMethod method);

/// [GLM17] section 4.4, ALGORITHMS: the root of the transport distance between the two Gaussian
/// textures over the model's variance, over all frequencies but 0. 0 for equal power spectra, 1 for
/// a texton of zeros.
[[nodiscard]] double relativeModelError(const gaussian::GaussianModel& model,
                                        const TextonCoefficients& coefficients, int order);

} // namespace lichen::texton
