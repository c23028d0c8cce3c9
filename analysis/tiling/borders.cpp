// SPDX-License-Identifier: MIT
// Seam detection on exemplars and seam removal on Gaussian images of width * height points.
#include "borders.h"

#include "gaussian_distribution.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lichen::tiling {
namespace {

constexpr int kFewestForDetection = 8;

/// Measured on photographs and their crops: docs/decisions/006-seam-detection.md.
constexpr double kSeamThreshold = 1.25;
constexpr double kPercentile = 0.9;
constexpr int kRunPixels = 4;

/// Width of the cross-faded band on each side of a seam, as a share of the side: an eighth in all.
constexpr double kBandPerSide = 1.0 / 16.0;

/// How much line k and line k + 1 (wrapping) differ, for every k: differences averaged over runs of
/// kRunPixels along the line, then their absolute values. Grain averages out of a run; a step that
/// the eye follows along the seam does not. A line is a column when `alongX`.
std::vector<double> lineDifferences(const MapExemplar& map, bool alongX) {
  const int lines = alongX ? map.width : map.height;
  const int length = alongX ? map.height : map.width;
  const int run = std::min(kRunPixels, length);
  const std::size_t channels = map.channels.size();
  const std::size_t lineStride = channels * (alongX ? 1u : std::size_t(map.width));
  const std::size_t stride = channels * (alongX ? std::size_t(map.width) : 1u);
  std::vector<double> sums(std::size_t(lines), 0.0);
  for (int line = 0; line < lines; ++line)
    for (std::size_t c = 0; c < channels; ++c) {
      const float* here = &map.values[std::size_t(line) * lineStride + c];
      const float* next = &map.values[std::size_t((line + 1) % lines) * lineStride + c];
      const auto difference = [&](int k) {
        return double(next[std::size_t(k) * stride]) - double(here[std::size_t(k) * stride]);
      };
      double sum = 0.0;
      for (int k = 0; k < length; ++k) {
        sum += difference(k);
        if (k + 1 < run)
          continue;
        sums[std::size_t(line)] += std::abs(sum);
        sum -= difference(k + 1 - run);
      }
    }
  return sums;
}

double strengthOf(std::vector<double> differences) {
  const double seam = differences.back();
  differences.pop_back();
  const auto place = differences.begin() + std::ptrdiff_t(kPercentile * double(differences.size()));
  std::nth_element(differences.begin(), place, differences.end());
  if (*place > 0.0)
    return seam / *place;
  return seam > 0.0 ? std::numeric_limits<double>::infinity() : 0.0;
}

Point blended(const Point& a, const Point& b, double weightB) {
  const double weightA = 1.0 - weightB;
  const double scale = 1.0 / std::sqrt(weightA * weightA + weightB * weightB);
  const auto channel = [&](float x, float y) {
    return float(kGaussianMean + scale * (weightA * (double(x) - kGaussianMean) +
                                          weightB * (double(y) - kGaussianMean)));
  };
  return {channel(a.x, b.x), channel(a.y, b.y), channel(a.z, b.z)};
}

/// Weight of the displaced image at pixel k of a side: 1 on the seam, 0 beyond the band, with a
/// smooth step between, so that no edge of the band shows.
double seamWeight(int k, int side) {
  const int fromSeam = std::min(k, side - 1 - k);
  const double t = 1.0 - std::min(1.0, fromSeam / std::max(1.0, kBandPerSide * side));
  return t * t * (3.0 - 2.0 * t);
}

} // namespace

SeamStrength seamStrength(const MapExemplar& map) {
  SeamStrength strength;
  if (map.width >= kFewestForDetection)
    strength.betweenColumns = strengthOf(lineDifferences(map, true));
  if (map.height >= kFewestForDetection)
    strength.betweenRows = strengthOf(lineDifferences(map, false));
  return strength;
}

bool isPeriodic(const MapExemplar& map) {
  const SeamStrength strength = seamStrength(map);
  return std::max(strength.betweenColumns, strength.betweenRows) <= kSeamThreshold;
}

std::vector<Point> crossFadeBorders(const std::vector<Point>& image, int width, int height) {
  std::vector<Point> horizontal(image.size());
  const auto at = [width](int x, int y) {
    return std::size_t(y) * std::size_t(width) + std::size_t(x);
  };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      horizontal[at(x, y)] =
          blended(image[at(x, y)], image[at((x + width / 2) % width, y)], seamWeight(x, width));
  std::vector<Point> result(image.size());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      result[at(x, y)] = blended(horizontal[at(x, y)], horizontal[at(x, (y + height / 2) % height)],
                                 seamWeight(y, height));
  return result;
}

} // namespace lichen::tiling
