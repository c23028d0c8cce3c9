// SPDX-License-Identifier: MIT
// Autocovariance of a plane (height, width) -> (2 support - 1, 2 support - 1), by the
// Wiener-Khinchin theorem on a zero-padded plane.
#include <lichen/fft.h>
#include <lichen/spectrum.h>

#include <cassert>
#include <cstdlib>
#include <numeric>

namespace lichen {

std::vector<double> autocovariance(std::span<const float> plane, int width, int height,
                                   int support) {
  assert(support >= 1 && support <= width && support <= height);
  const double mean = std::accumulate(plane.begin(), plane.end(), 0.0) / double(plane.size());
  const int paddedWidth = fastTransformSize(width + support - 1);
  const int paddedHeight = fastTransformSize(height + support - 1);
  std::vector<float> padded(std::size_t(paddedWidth) * std::size_t(paddedHeight), 0.0f);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      padded[std::size_t(y) * std::size_t(paddedWidth) + std::size_t(x)] =
          float(double(plane[std::size_t(y) * std::size_t(width) + std::size_t(x)]) - mean);

  HalfSpectrum spectrum = forwardFft(padded, paddedWidth, paddedHeight);
  for (std::complex<float>& value : spectrum.values)
    value = {std::norm(value), 0.0f};
  const std::vector<float> sums = inverseFft(spectrum);

  std::vector<double> covariance;
  covariance.reserve(std::size_t(2 * support - 1) * std::size_t(2 * support - 1));
  for (int dy = 1 - support; dy < support; ++dy) {
    for (int dx = 1 - support; dx < support; ++dx) {
      const int x = (dx + paddedWidth) % paddedWidth;
      const int y = (dy + paddedHeight) % paddedHeight;
      const double pairs = double(width - std::abs(dx)) * double(height - std::abs(dy));
      covariance.push_back(
          double(sums[std::size_t(y) * std::size_t(paddedWidth) + std::size_t(x)]) / pairs);
    }
  }
  return covariance;
}

} // namespace lichen
