// SPDX-License-Identifier: MIT
// Picture (height, width, channels) -> its correlation with itself (2 height, 2 width), by Fourier
// transforms of the picture padded with zeros.
#include "self_similarity.h"

#include "exemplar/color_space.h"

#include <lichen/fft.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

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

BorderMisfit::BorderMisfit(const exemplar::ImageLevel& image) : image_(image) {
  unrelated_ = 2.0 * exemplar::momentsOf(image.values, image.channels).covariance.trace();
}

double BorderMisfit::between(const std::array<double, 2>& from, const std::array<double, 2>& side,
                             const std::array<double, 2>& apart) const {
  constexpr int kWinding = 2; // pixels
  const auto channels = std::size_t(image_.channels);
  const auto pixelAt = [&](double x, double y) {
    const int column = std::clamp(int(std::floor(x)), 0, image_.width - 1);
    const int row = std::clamp(int(std::floor(y)), 0, image_.height - 1);
    return &image_.values[(std::size_t(row) * std::size_t(image_.width) + std::size_t(column)) *
                          channels];
  };
  const double distance = std::max(1.0, std::hypot(apart[0], apart[1])); // of a pixel: 0
  const int samples = std::max(1, int(std::hypot(side[0], side[1])));
  double sum = 0.0;
  for (int k = 0; k < samples; ++k) {
    const double along = (k + 0.5) / samples;
    const double x = from[0] + along * side[0], y = from[1] + along * side[1];
    const float* const near = pixelAt(x, y);
    double least = 0.0;
    for (int across = -kWinding; across <= kWinding; ++across) {
      const double share = 1.0 + across / distance;
      const float* const far = pixelAt(x + share * apart[0], y + share * apart[1]);
      double squares = 0.0;
      for (std::size_t c = 0; c < channels; ++c)
        squares += std::pow(double(near[c]) - double(far[c]), 2.0);
      least = across == -kWinding ? squares : std::min(least, squares);
    }
    sum += least;
  }
  constexpr double kNoVariance = 1e-4; // a deviation of two code values
  return unrelated_ > 2.0 * kNoVariance ? sum / (samples * unrelated_) : 0.0;
}

bool BorderMisfit::bordersLookAlike(std::size_t axis) const {
  constexpr double kMostMisfit = 0.125; // docs/decisions/012-quilting.md
  const double width = image_.width, height = image_.height;
  const std::array<double, 2> from{0.0, 0.0};
  return (axis == 0 ? between(from, {0.0, height}, {width - 1.0, 0.0})
                    : between(from, {width, 0.0}, {0.0, height - 1.0})) < kMostMisfit;
}

} // namespace lichen::placement
