// SPDX-License-Identifier: MIT
// Radially averaged power spectrum of a plane (height, width) -> (cropSide / 2 + 1).
//
// Source: [W67].
#include <lichen/fft.h>
#include <lichen/spectrum.h>

#include <tbb/parallel_for.h>

#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>

namespace lichen {
namespace {

/// The periodic Hann window. Its own spectrum is three lines wide.
std::vector<float> hannWindow(int side) {
  std::vector<float> window(std::size_t(side), 0.0f);
  for (int x = 0; x < side; ++x)
    window[std::size_t(x)] =
        float(0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * double(x) / double(side)));
  return window;
}

/// Adds each frequency's power to the ring that its radius rounds to.
void addRings(const HalfSpectrum& spectrum, std::vector<double>& rings) {
  for (int v = 0; v < spectrum.height; ++v) {
    const int signedV = spectrum.signedRow(v);
    for (int u = 0; u < spectrum.columns(); ++u) {
      const auto ring = std::size_t(std::lround(std::hypot(double(u), double(signedV))));
      if (ring < rings.size())
        rings[ring] += spectrum.multiplicity(u) * double(std::norm(spectrum.at(u, v)));
    }
  }
}

/// The number of frequencies in each ring.
std::vector<double> ringSizes(int cropSide) {
  HalfSpectrum ones{cropSide, cropSide, {}};
  ones.values.assign(std::size_t(ones.columns()) * std::size_t(cropSide), {1.0f, 0.0f});
  std::vector<double> sizes(std::size_t(cropSide / 2 + 1), 0.0);
  addRings(ones, sizes);
  return sizes;
}

} // namespace

std::vector<float> luminancePlane(const SrgbImage& image) {
  std::vector<float> plane(image.pixelCount());
  const auto channels = std::size_t(image.channels);
  for (std::size_t i = 0; i < plane.size(); ++i) {
    const float* p = image.values.data() + i * channels;
    const auto& [red, green, blue] = kLuminanceWeights;
    plane[i] = channels >= 3 ? red * p[0] + green * p[1] + blue * p[2] : p[0];
  }
  return plane;
}

std::vector<double> radialPowerSpectrum(std::span<const float> plane, int width, int height,
                                        int cropSide) {
  assert(cropSide >= 2 && cropSide % 2 == 0 && cropSide <= width && cropSide <= height);
  const std::vector<float> window = hannWindow(cropSide);
  // Subtracted before the transform: the window would confine the mean to rings 0 and 1, but float
  // rounding would spread it.
  const double mean = std::accumulate(plane.begin(), plane.end(), 0.0) / double(plane.size());
  const int step = cropSide / 2;
  const int cropsX = (width - cropSide) / step + 1;
  const int cropsY = (height - cropSide) / step + 1;

  // One sum per row of crops, added in order afterwards, so the result does not depend on the
  // number of threads.
  std::vector<std::vector<double>> rowRings(std::size_t(cropsY),
                                            std::vector<double>(std::size_t(step + 1), 0.0));
  tbb::parallel_for(0, cropsY, [&](int row) {
    std::vector<float> crop(std::size_t(cropSide) * std::size_t(cropSide));
    for (int column = 0; column < cropsX; ++column) {
      for (int y = 0; y < cropSide; ++y) {
        for (int x = 0; x < cropSide; ++x) {
          const std::size_t from =
              std::size_t(row * step + y) * std::size_t(width) + std::size_t(column * step + x);
          crop[std::size_t(y) * std::size_t(cropSide) + std::size_t(x)] =
              float(double(plane[from]) - mean) * window[std::size_t(x)] * window[std::size_t(y)];
        }
      }
      addRings(forwardFft(crop, cropSide, cropSide), rowRings[std::size_t(row)]);
    }
  });

  const double windowEnergy = std::inner_product(window.begin(), window.end(), window.begin(), 0.0);
  const double crops = double(cropsX) * double(cropsY);
  std::vector<double> power = ringSizes(cropSide);
  for (std::size_t ring = 0; ring < power.size(); ++ring) {
    double sum = 0.0;
    for (const std::vector<double>& rings : rowRings)
      sum += rings[ring];
    power[ring] = sum / (power[ring] * crops * windowEnergy * windowEnergy);
  }
  return power;
}

} // namespace lichen
