// SPDX-License-Identifier: MIT
// Plane -> the direction that its gradients prefer, and how much, from their structure tensor.
// Source: [BG87] Bigun and Granlund, Optimal Orientation Detection of Linear Symmetry, 1987.
#include <lichen/measures.h>
#include <lichen/spectrum.h>

#include <cmath>

namespace lichen {

GradientDirection gradientDirection(std::span<const float> plane, int width, int height) {
  // [S00] 3 x 3 operator, whose direction is right to a fraction of a degree. Differences of
  // neighbours favour the axes, by up to 5 degrees.
  constexpr double kSide = 3.0 / 32.0, kMiddle = 10.0 / 32.0;
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (int y = 1; y + 1 < height; ++y)
    for (int x = 1; x + 1 < width; ++x) {
      const auto at = [&](int dx, int dy) {
        return double(plane[std::size_t(y + dy) * std::size_t(width) + std::size_t(x + dx)]);
      };
      const double right = kSide * (at(1, -1) - at(-1, -1) + at(1, 1) - at(-1, 1)) +
                           kMiddle * (at(1, 0) - at(-1, 0));
      const double down = kSide * (at(-1, 1) - at(-1, -1) + at(1, 1) - at(1, -1)) +
                          kMiddle * (at(0, 1) - at(0, -1));
      xx += right * right;
      xy += right * down;
      yy += down * down;
    }
  const double energy = xx + yy;
  if (energy <= 0.0)
    return {};
  return {std::hypot(xx - yy, 2.0 * xy) / energy, 0.5 * std::atan2(2.0 * xy, xx - yy)};
}

double gradientAnisotropy(const SrgbImage& image) {
  return gradientDirection(luminancePlane(image), image.width, image.height).anisotropy;
}

} // namespace lichen
