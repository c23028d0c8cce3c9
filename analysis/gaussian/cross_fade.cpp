// SPDX-License-Identifier: MIT
// Gaussian image (width * height points) -> the same with matching borders.
#include "cross_fade.h"

#include "gaussian_distribution.h"

#include <algorithm>
#include <cmath>

namespace lichen::gaussian {
namespace {

/// Width of the cross-faded band on each side of a seam, as a share of the side: an eighth in
/// total.
constexpr double kBandPerSide = 1.0 / 16.0;

Point blended(const Point& a, const Point& b, double weightB) {
  const double weightA = 1.0 - weightB;
  const double scale = 1.0 / std::sqrt(weightA * weightA + weightB * weightB);
  const auto channel = [&](float x, float y) {
    return float(kGaussianMean + scale * (weightA * (double(x) - kGaussianMean) +
                                          weightB * (double(y) - kGaussianMean)));
  };
  return {channel(a.x, b.x), channel(a.y, b.y), channel(a.z, b.z)};
}

/// Returns the weight of the displaced image at pixel k of a side: 1 on the seam and 0 outside the
/// band, with a smooth step between, so that the band has no visible edge.
double seamWeight(int k, int side) {
  const int fromSeam = std::min(k, side - 1 - k);
  const double t = 1.0 - std::min(1.0, fromSeam / std::max(1.0, kBandPerSide * side));
  return t * t * (3.0 - 2.0 * t);
}

} // namespace

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

} // namespace lichen::gaussian
