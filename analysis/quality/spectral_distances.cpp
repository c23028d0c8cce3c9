// SPDX-License-Identifier: MIT
// Distances between the second-order statistics of two images' luminance: radially averaged power
// spectra, and autocovariances.
#include "boundary.h"

#include <lichen/quality.h>
#include <lichen/spectrum.h>

#include <cmath>
#include <vector>

namespace lichen {
namespace {

/// The shortest side whose crops still have one ring.
constexpr int kSmallestSide = 32;
static_assert(comparedCropSide(kSmallestSide) == 2 * kLowestComparedCycles);
/// Variance of rounding to 8 bits, which is also its power at every frequency.
constexpr double kRoundingPower = 1.0 / (255.0 * 255.0 * 12.0);

std::vector<double> spectrumDb(const SrgbImage& image, int cropSide) {
  std::vector<double> power =
      radialPowerSpectrum(luminancePlane(image), image.width, image.height, cropSide);
  for (double& value : power)
    value = 10.0 * std::log10(std::max(value, kRoundingPower));
  return power;
}

/// The autocovariance divided by the variance; all 0 if the variance is only float rounding.
std::vector<double> normalizedAutocovariance(const SrgbImage& image, int support) {
  std::vector<double> covariance =
      autocovariance(luminancePlane(image), image.width, image.height, support);
  const double variance = covariance[covariance.size() / 2];
  constexpr double kNoVariance = 1e-12;
  for (double& value : covariance)
    value = variance > kNoVariance ? value / variance : 0.0;
  return covariance;
}

} // namespace

Result<double> spectrumDistanceDb(const SrgbImage& exemplar, const SrgbImage& result) {
  return withinMemory(exhausted, [&]() -> Result<double> {
    if (auto error = refusal(exemplar, result, kSmallestSide))
      return *error;
    const int crop = comparedCropSide(std::min(shorterSide(exemplar), shorterSide(result)));
    const std::vector<double> a = spectrumDb(exemplar, crop);
    const std::vector<double> b = spectrumDb(result, crop);
    double sum = 0.0;
    for (std::size_t ring = kLowestComparedCycles; ring < a.size(); ++ring)
      sum += (a[ring] - b[ring]) * (a[ring] - b[ring]);
    return std::sqrt(sum / double(a.size() - kLowestComparedCycles));
  });
}

Result<double> autocovarianceError(const SrgbImage& exemplar, const SrgbImage& result,
                                   int supportPixels) {
  return withinMemory(exhausted, [&]() -> Result<double> {
    constexpr int kSmallestSupport = 2;
    constexpr int kSupportsPerSide = 4; // so that every lag has enough pairs
    if (auto error = refusal(exemplar, result, kSmallestSupport * kSupportsPerSide))
      return *error;
    const int largest = std::min(shorterSide(exemplar), shorterSide(result)) / kSupportsPerSide;
    if (supportPixels < kSmallestSupport || supportPixels > largest)
      return Error{ErrorKind::usage, "support " + std::to_string(supportPixels) + "; expected " +
                                         std::to_string(kSmallestSupport) + " to " +
                                         std::to_string(largest) + " pixels for these images"};
    const std::vector<double> a = normalizedAutocovariance(exemplar, supportPixels);
    const std::vector<double> b = normalizedAutocovariance(result, supportPixels);
    double difference = 0.0, norm = 0.0;
    for (std::size_t lag = 0; lag < a.size(); ++lag) {
      difference += (a[lag] - b[lag]) * (a[lag] - b[lag]);
      norm += a[lag] * a[lag];
    }
    if (norm == 0.0)
      return difference == 0.0 ? 0.0 : 1.0;
    return std::sqrt(difference / norm);
  });
}

} // namespace lichen
