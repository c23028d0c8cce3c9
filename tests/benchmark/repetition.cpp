// SPDX-License-Identifier: MIT
// Picture -> its autocorrelation, by a Fourier transform -> the highest of the moves that count.
#include "repetition.h"

#include <lichen/fft.h>
#include <lichen/spectrum.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace lichen::bench {
namespace {

/// The luminance less its mean.
std::vector<float> deviationsOf(const SrgbImage& image) {
  std::vector<float> plane = luminancePlane(image);
  double sum = 0.0;
  for (const float value : plane)
    sum += value;
  const auto mean = float(sum / double(plane.size()));
  for (float& value : plane)
    value -= mean;
  return plane;
}

/// The sum over all pixels of the product with the plane moved by (x, y), at [y * width + x]. The
/// plane repeats.
std::vector<float> autocorrelation(const std::vector<float>& plane, int width, int height) {
  HalfSpectrum spectrum = forwardFft(plane, width, height);
  for (std::complex<float>& value : spectrum.values)
    value = std::norm(value);
  return inverseFft(spectrum);
}

/// The distance of a move from the nearest whole repeat, along one axis.
double fromRepeat(int move, int side) { return double(std::min(move, side - move)); }

} // namespace

double repetition(const SrgbImage& result, double leastPixels) {
  const int width = 2 * result.width, height = 2 * result.height; // so that nothing wraps around
  const std::vector<float> inside = deviationsOf(result);
  std::vector<float> padded(std::size_t(width) * std::size_t(height));
  for (int y = 0; y < result.height; ++y)
    std::copy_n(inside.begin() + std::ptrdiff_t(y) * result.width, result.width,
                padded.begin() + std::ptrdiff_t(y) * width);
  const std::vector<float> sums = autocorrelation(padded, width, height);
  const double variance = double(sums[0]) / (double(result.width) * result.height);
  double highest = -1.0;
  for (int y = 0; y <= result.height / 2; ++y)
    for (int x = -result.width / 2; x <= result.width / 2; ++x) {
      if (std::hypot(x, y) < leastPixels)
        continue;
      const double pairs = double(result.width - std::abs(x)) * (result.height - y);
      const std::size_t at =
          std::size_t(y) * std::size_t(width) + std::size_t(x < 0 ? x + width : x);
      highest = std::max(highest, double(sums[at]) / (pairs * variance));
    }
  return highest;
}

double repetitionOfPlainRepeat(const SrgbImage& exemplar, double leastPixels) {
  const std::vector<float> sums =
      autocorrelation(deviationsOf(exemplar), exemplar.width, exemplar.height);
  float highest = -sums[0];
  for (int y = 0; y < exemplar.height; ++y)
    for (int x = 0; x < exemplar.width; ++x)
      if (std::hypot(fromRepeat(x, exemplar.width), fromRepeat(y, exemplar.height)) >= leastPixels)
        highest =
            std::max(highest, sums[std::size_t(y) * std::size_t(exemplar.width) + std::size_t(x)]);
  return double(highest) / double(sums[0]);
}

} // namespace lichen::bench
