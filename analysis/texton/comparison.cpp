// SPDX-License-Identifier: MIT
// Gaussian model and support -> error and kurtosis of three spots of that support.
//
// The kurtosis is that of Campbell's theorem: the cumulant of order n of a renormalised spot noise
// is sum h^n / intensity^(n / 2 - 1), and intensity = impacts / support. Source: [GLM14] section 4.
#include "comparison.h"

#include "comparison_kernels.h"

#include <cassert>
#include <cmath>

namespace lichen::texton {

double flatness(const TextonCoefficients& spot, std::span<const float> weights) {
  assert(weights.size() == std::size_t(spot.channels));
  const std::size_t pixels = std::size_t(spot.width) * std::size_t(spot.height);
  double squares = 0.0;
  double fourths = 0.0;
  for (std::size_t i = 0; i < pixels; ++i) {
    double value = 0.0;
    for (std::size_t c = 0; c < weights.size(); ++c)
      value += double(weights[c]) * double(spot.values[c * pixels + i]);
    squares += value * value;
    fourths += value * value * value * value;
  }
  return squares > 0.0 ? double(pixels) * fourths / (squares * squares) : 0.0;
}

KernelComparison compareKernels(const GaussianModel& model, std::span<const float> weights,
                                const ComparisonOptions& options) {
  assert(options.impacts > 0.0);
  constexpr int kOrder = 0;
  const auto judged = [&](const TextonCoefficients& spot) {
    KernelJudgement judgement;
    judgement.relativeError = relativeModelError(model, spot, kOrder);
    judgement.flatness = flatness(spot, weights);
    judgement.excessKurtosis = judgement.flatness / options.impacts;
    return judgement;
  };
  FitOptions fit;
  fit.width = options.width;
  fit.height = options.height;
  fit.order = kOrder;
  fit.seed = options.seed;
  return {judged(fitCoefficients(model, fit, FitMethod::transportDistance)),
          judged(luminanceTexton(model, options.width, options.height)),
          judged(randomPhaseKernel(model, options.width, options.height, options.seed))};
}

} // namespace lichen::texton
