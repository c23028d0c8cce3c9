// SPDX-License-Identifier: MIT
// Texton -> the ratio of the fourth to the squared second moment of its texels.
//
// The kurtosis of the noise follows from Campbell's theorem: the cumulant of order n of a
// renormalised spot noise is sum h^n / intensity^(n / 2 - 1), where intensity = impacts / support.
// Source: [GLM14] section 4.
#include "flatness.h"

#include <lichen/spectrum.h>

#include <array>
#include <cassert>

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

TextonCoefficients interpolatedSpot(const TextonCoefficients& coefficients, int order) {
  if (order < 3)
    return coefficients;
  constexpr std::array<float, 3> kCubic = {1.0f / 6.0f, 4.0f / 6.0f, 1.0f / 6.0f};
  TextonCoefficients spot{
      coefficients.width + 2, coefficients.height + 2, coefficients.channels, {}};
  spot.values.resize(std::size_t(spot.width) * std::size_t(spot.height) *
                     std::size_t(spot.channels));
  const auto at = [](const TextonCoefficients& plane, int x, int y, int c) {
    return (std::size_t(c) * std::size_t(plane.height) + std::size_t(y)) *
               std::size_t(plane.width) +
           std::size_t(x);
  };
  for (int c = 0; c < spot.channels; ++c)
    for (int y = 0; y < coefficients.height; ++y)
      for (int x = 0; x < coefficients.width; ++x)
        for (int k = 0; k < 9; ++k)
          spot.values[at(spot, x + k % 3, y + k / 3, c)] +=
              kCubic[std::size_t(k % 3)] * kCubic[std::size_t(k / 3)] *
              coefficients.values[at(coefficients, x, y, c)];
  return spot;
}

std::vector<float> seenWeights(std::span<const MapChannel> channels) {
  if (channels.front() == MapChannel::red)
    return {kLuminanceWeights.begin(), kLuminanceWeights.end()};
  return std::vector<float>(channels.size(), 1.0f);
}

} // namespace lichen::texton
