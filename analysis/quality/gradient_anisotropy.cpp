// SPDX-License-Identifier: MIT
// Image -> how much its gradients prefer one direction, from the structure tensor of the image.
// Source: [BG87] Bigun and Granlund, Optimal Orientation Detection of Linear Symmetry, 1987.
#include <lichen/measures.h>
#include <lichen/spectrum.h>

#include <cmath>

namespace lichen {

double gradientAnisotropy(const SrgbImage& image) {
  const std::vector<float> plane = luminancePlane(image);
  const auto width = std::size_t(image.width);
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (std::size_t y = 0; y + 1 < std::size_t(image.height); ++y)
    for (std::size_t x = 0; x + 1 < width; ++x) {
      const float* at = &plane[y * width + x];
      // Both differences are at the centre of the 2 x 2 pixels.
      const double right = 0.5 * (double(at[1]) - at[0] + at[width + 1] - at[width]);
      const double down = 0.5 * (double(at[width]) - at[0] + at[width + 1] - at[1]);
      xx += right * right;
      xy += right * down;
      yy += down * down;
    }
  const double energy = xx + yy;
  return energy > 0.0 ? std::hypot(xx - yy, 2.0 * xy) / energy : 0.0;
}

} // namespace lichen
