// SPDX-License-Identifier: MIT
// Gaussian model and support -> error and kurtosis of three spots of that support.
//
// The kurtosis is that of Campbell's theorem: the cumulant of order n of a renormalised spot noise
// is sum h^n / intensity^(n / 2 - 1), and intensity = impacts / support. Source: [GLM14] section 4.
#include "comparison.h"

#include "comparison_kernels.h"
#include "interpolation.h"

#include <lichen/spectrum.h>

#include <cassert>

namespace lichen::texton {
namespace {

/// The model of coefficients whose B-spline interpolation has the given model. [GLM17] eq. 4.
GaussianModel coefficientModel(const GaussianModel& model, int order) {
  const std::vector<float> kernelX = kernelAmplitudes(order, model.width());
  const std::vector<float> kernelY = kernelAmplitudes(order, model.height());
  GaussianModel result = model;
  for (HalfSpectrum& channel : result.channels)
    for (int v = 0; v < channel.height; ++v)
      for (int u = 0; u < channel.columns(); ++u)
        channel.at(u, v) /= kernelX[std::size_t(u)] * kernelY[std::size_t(v)];
  return result;
}

} // namespace

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

std::vector<float> seenWeights(std::span<const MapChannel> channels) {
  if (channels.front() == MapChannel::red)
    return {kLuminanceWeights.begin(), kLuminanceWeights.end()};
  return std::vector<float>(channels.size(), 1.0f);
}

KernelComparison compareKernels(const GaussianModel& model, const TextonCoefficients& texton,
                                int order, std::span<const float> weights, std::uint32_t seed) {
  const auto judged = [&](const TextonCoefficients& spot) {
    return KernelJudgement{relativeModelError(model, spot, order), flatness(spot, weights)};
  };
  const GaussianModel coefficients = coefficientModel(model, order);
  return {judged(texton), judged(luminanceTexton(coefficients, texton.width, texton.height)),
          judged(randomPhaseKernel(coefficients, texton.width, texton.height, seed))};
}

} // namespace lichen::texton
