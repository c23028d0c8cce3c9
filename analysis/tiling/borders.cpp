// SPDX-License-Identifier: MIT
// Seam detection on exemplars and seam removal on Gaussian images of width * height points.
#include "borders.h"

#include "gaussian_distribution.h"

#include <algorithm>
#include <cmath>

namespace lichen::tiling {
namespace {

constexpr int kFewestForDetection = 8;

/// A seam shows when its mean difference leaves the spread of the interior's means: this many
/// times their 90th percentile. The exemplars of tests/property/tiling_bake.cpp stay below it and
/// their crops exceed it; photographs have not been tabulated.
constexpr double kSeamThreshold = 1.25;
constexpr double kPercentile = 0.9;

/// Width of the cross-faded band on each side of a seam, as a share of the side: an eighth in all.
constexpr double kBandPerSide = 1.0 / 16.0;

/// Mean absolute difference between line k and line k + 1 (wrapping), for every k. A line is a
/// column when `alongX`.
std::vector<double> lineDifferences(const MapExemplar& map, bool alongX) {
  const int lines = alongX ? map.width : map.height;
  const int length = alongX ? map.height : map.width;
  const auto channels = map.channels.size();
  std::vector<double> sums(std::size_t(lines), 0.0);
  for (int line = 0; line < lines; ++line) {
    const int next = (line + 1) % lines;
    for (int k = 0; k < length; ++k) {
      const auto index = [&](int l) {
        return (alongX ? std::size_t(k) * std::size_t(map.width) + std::size_t(l)
                       : std::size_t(l) * std::size_t(map.width) + std::size_t(k)) *
               channels;
      };
      const float* a = &map.values[index(line)];
      const float* b = &map.values[index(next)];
      for (std::size_t c = 0; c < channels; ++c)
        sums[std::size_t(line)] += std::abs(double(a[c]) - double(b[c]));
    }
  }
  return sums;
}

bool hasSeam(std::vector<double> differences) {
  const double seam = differences.back();
  differences.pop_back();
  const auto place = differences.begin() + std::ptrdiff_t(kPercentile * double(differences.size()));
  std::nth_element(differences.begin(), place, differences.end());
  return seam > kSeamThreshold * *place;
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

bool isPeriodic(const MapExemplar& map) {
  return (map.width < kFewestForDetection || !hasSeam(lineDifferences(map, true))) &&
         (map.height < kFewestForDetection || !hasSeam(lineDifferences(map, false)));
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
