// SPDX-License-Identifier: MIT
// Images -> smaller pictures and spectra; see section_figures.h.
#include "section_figures.h"

#include <lichen/spectrum.h>

#include <algorithm>
#include <cmath>

namespace lichen {
namespace {

template <Encoding kEncoding>
Image<kEncoding> blockMeans(const Image<kEncoding>& image, int width, int height) {
  Image<kEncoding> small(width, height, image.channels);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const int left = x * image.width / width, right = (x + 1) * image.width / width;
      const int top = y * image.height / height, bottom = (y + 1) * image.height / height;
      for (int c = 0; c < image.channels; ++c) {
        double sum = 0.0;
        for (int v = top; v < bottom; ++v)
          for (int u = left; u < right; ++u)
            sum += double(image.pixel(u, v)[c]);
        small.pixel(x, y)[c] = float(sum / (double(right - left) * double(bottom - top)));
      }
    }
  return small;
}

} // namespace

Extents pictureExtents(int width, int height, int side) {
  const double shrink = std::min(1.0, side / std::sqrt(double(width) * double(height)));
  Extents extents{std::max(1, int(width * shrink)), std::max(1, int(height * shrink))};
  for (int& extent : extents) // of an image less than a pixel wide
    extent = std::min(extent, side * side);
  return extents;
}

SrgbImage reduced(const SrgbImage& image, int width, int height) {
  return blockMeans(image, width, height);
}

LinearImage reduced(const LinearImage& image, int width, int height) {
  return blockMeans(image, width, height);
}

int spectrumCrop(const SrgbImage& a, const SrgbImage& b) {
  const int crop = comparedCropSide(std::min({a.width, a.height, b.width, b.height}));
  return crop < 2 * kLowestComparedCycles ? 0 : crop;
}

std::vector<double> decibels(const SrgbImage& image, int crop) {
  constexpr double kLeastPower = 1e-12; // power of an image without variance
  std::vector<double> power =
      radialPowerSpectrum(luminancePlane(image), image.width, image.height, crop);
  for (double& value : power)
    value = 10.0 * std::log10(std::max(value, kLeastPower));
  return power;
}

} // namespace lichen
