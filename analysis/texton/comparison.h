// SPDX-License-Identifier: MIT
// What a synthesis-oriented texton is worth beside the other spots of its support.
#pragma once

#include "fit.h"

#include <cstdint>
#include <span>

namespace lichen::texton {

/// r^2 sum l^4 / (sum l^2)^2 over the support's r^2 pixels, l the channels' sum weighted by
/// `weights`, one a channel: 1 for a spot of one magnitude, 3 for values normally distributed, r^2
/// for a spot of one pixel. 0 for a spot of zeros.
[[nodiscard]] double flatness(const TextonCoefficients& spot, std::span<const float> weights);

struct KernelJudgement {
  /// relativeModelError as spot noise of order 0: of the limit of high intensities.
  double relativeError = 0.0;
  double flatness = 0.0;
  /// Excess kurtosis of the spot noise at the given impacts a pixel: flatness / impacts. 0 is
  /// normal; what the limit's normality lacks.
  double excessKurtosis = 0.0;
};

/// The kernels of [GLM14] figure 4, of one support.
struct KernelComparison {
  KernelJudgement synthesisOriented;
  KernelJudgement luminance;
  KernelJudgement randomPhase;
};

struct ComparisonOptions {
  int width = 0;         ///< of the support in pixels, [1, the model's width]
  int height = 0;        ///< [1, the model's height]
  double impacts = 30.0; ///< mean number a pixel, > 0
  std::uint32_t seed = 1;
};

/// `weights` as for flatness. Takes the time of one fit. Same bytes for any number of threads.
[[nodiscard]] KernelComparison compareKernels(const GaussianModel& model,
                                              std::span<const float> weights,
                                              const ComparisonOptions& options);

} // namespace lichen::texton
