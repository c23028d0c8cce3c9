// SPDX-License-Identifier: MIT
// Picture (height, width, channels) -> its correlation with itself (2 height, 2 width), by Fourier
// transforms of the picture padded with zeros.
#include "self_correlation.h"

#include <lichen/fft.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

namespace lichen::placement {
namespace {

using exemplar::ImageLevel;

/// Each plane padded with zeros to twice the sides.
HalfSpectrum paddedSpectrum(const ImageLevel& image, const auto& valueAt) {
  const int width = 2 * image.width, height = 2 * image.height;
  std::vector<float> padded(std::size_t(width) * std::size_t(height));
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      padded[std::size_t(y) * std::size_t(width) + std::size_t(x)] =
          valueAt(std::size_t(y) * std::size_t(image.width) + std::size_t(x));
  return forwardFft(padded, width, height);
}

} // namespace

SelfCorrelation selfCorrelation(const ImageLevel& image) {
  constexpr double kLeastOverlap = 0.02; // of the picture
  const auto channels = std::size_t(image.channels);
  HalfSpectrum power;
  for (std::size_t c = 0; c < channels; ++c) {
    HalfSpectrum spectrum =
        paddedSpectrum(image, [&](std::size_t i) { return image.values[i * channels + c]; });
    for (std::size_t i = 0; i < spectrum.values.size(); ++i)
      spectrum.values[i] =
          std::norm(spectrum.values[i]) + (c > 0 ? power.values[i] : std::complex<float>());
    power = std::move(spectrum);
  }
  const HalfSpectrum ones = paddedSpectrum(image, [](std::size_t) { return 1.0f; });
  HalfSpectrum energy = paddedSpectrum(image, [&](std::size_t i) {
    float sum = 0.0f;
    for (std::size_t c = 0; c < channels; ++c)
      sum += image.values[i * channels + c] * image.values[i * channels + c];
    return sum;
  });
  HalfSpectrum overlap = ones;
  for (std::size_t i = 0; i < ones.values.size(); ++i) {
    overlap.values[i] = std::norm(ones.values[i]);
    energy.values[i] *= std::conj(ones.values[i]);
  }
  // The energy of the pixels that have a partner: at s of those before, at -s of those after.
  const std::vector<float> energies = inverseFft(energy), overlaps = inverseFft(overlap);
  SelfCorrelation result{power.width, power.height, inverseFft(power)};
  const float least = float(kLeastOverlap) * float(image.width) * float(image.height);
  for (int y = 0; y < result.height; ++y)
    for (int x = 0; x < result.width; ++x) {
      const std::size_t i = std::size_t(y) * std::size_t(result.width) + std::size_t(x);
      const std::size_t opposite =
          std::size_t((result.height - y) % result.height) * std::size_t(result.width) +
          std::size_t((result.width - x) % result.width);
      const float norm =
          std::sqrt(std::max(0.0f, energies[i]) * std::max(0.0f, energies[opposite]));
      result.values[i] = overlaps[i] > least && norm > 0.0f ? result.values[i] / norm : 0.0f;
    }
  return result;
}

} // namespace lichen::placement
