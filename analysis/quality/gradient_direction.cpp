// SPDX-License-Identifier: MIT
// Plane -> the direction that its gradients prefer, and how much, from their structure tensor.
// Source: [BG87] Bigun and Granlund, Optimal Orientation Detection of Linear Symmetry, 1987.
#include <lichen/measures.h>
#include <lichen/spectrum.h>

#include <cmath>

namespace lichen {

GradientDirection gradientDirection(std::span<const float> plane, int width, int height) {
  double xx = 0.0, xy = 0.0, yy = 0.0;
  const auto stride = std::size_t(width);
  for (std::size_t y = 0; y + 1 < std::size_t(height); ++y)
    for (std::size_t x = 0; x + 1 < stride; ++x) {
      const float* at = &plane[y * stride + x];
      // Both differences are at the centre of the 2 x 2 pixels.
      const double right = 0.5 * (double(at[1]) - at[0] + at[stride + 1] - at[stride]);
      const double down = 0.5 * (double(at[stride]) - at[0] + at[stride + 1] - at[1]);
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
