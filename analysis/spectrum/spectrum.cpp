// SPDX-License-Identifier: MIT
// Radially averaged power spectrum of a plane (height, width) -> (cropSide / 2 + 1).
//
// Source: [W67].
#include <lichen/fft.h>
#include <lichen/lattice.h>
#include <lichen/spectrum.h>

#include <tbb/parallel_for.h>

#include <cassert>
#include <cmath>
#include <cstdlib>
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

// The periodic component of a plane (height, width): the plane minus a smooth plane whose Laplacian
// is the jumps across the borders. Takes one forward and one inverse transform.
//
// Source: [M11], algorithm 1.
namespace {

/// The jumps between opposite borders, at the pixels of both. They sum to zero.
std::vector<float> borderJumps(std::span<const float> plane, int width, int height) {
  std::vector<float> jumps(plane.size(), 0.0f);
  const auto at = [width](int x, int y) {
    return std::size_t(y) * std::size_t(width) + std::size_t(x);
  };
  const auto add = [&](std::size_t first, std::size_t last) {
    const float jump = plane[last] - plane[first];
    jumps[first] += jump;
    jumps[last] -= jump;
  };
  for (int x = 0; x < width; ++x)
    add(at(x, 0), at(x, height - 1));
  for (int y = 0; y < height; ++y)
    add(at(0, y), at(width - 1, y));
  return jumps;
}

} // namespace

std::vector<float> periodicComponent(std::span<const float> plane, int width, int height) {
  assert(width >= 1 && height >= 1 && plane.size() == std::size_t(width) * std::size_t(height));
  HalfSpectrum smooth = forwardFft(borderJumps(plane, width, height), width, height);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < smooth.columns(); ++u) {
      // [M11] eq. 11: divides by the discrete Laplacian, which is 0 only at frequency 0.
      const double laplacian = 2.0 * std::cos(2.0 * std::numbers::pi * u / width) +
                               2.0 * std::cos(2.0 * std::numbers::pi * v / height) - 4.0;
      smooth.at(u, v) *= u == 0 && v == 0 ? 0.0f : float(1.0 / laplacian);
    }
  }
  std::vector<float> periodic = inverseFft(smooth);
  for (std::size_t i = 0; i < periodic.size(); ++i)
    periodic[i] = plane[i] - periodic[i];
  return periodic;
}

// Fourier transforms of planes (height, width) -> their periodograms, per frequency.

HalfSpectrum crossSpectrum(const HalfSpectrum& a, const HalfSpectrum& b) {
  assert(a.width == b.width && a.height == b.height);
  const float scale = 1.0f / (float(a.width) * float(a.height));
  HalfSpectrum cross{a.width, a.height, {}};
  cross.values.reserve(a.values.size());
  for (std::size_t i = 0; i < a.values.size(); ++i)
    cross.values.push_back(std::conj(a.values[i]) * b.values[i] * scale);
  return cross;
}

std::vector<float> powerSpectrum(const HalfSpectrum& plane) {
  const float scale = 1.0f / (float(plane.width) * float(plane.height));
  std::vector<float> power;
  power.reserve(plane.values.size());
  for (const std::complex<float>& value : plane.values)
    power.push_back(std::norm(value) * scale);
  return power;
}

// A plane (height, width) with a given power spectrum and random phases.
//
// Source: [GGM11].

std::vector<float> phaseRandomizedPlane(const HalfSpectrum& spectrum, std::uint32_t seed) {
  // The phases of white noise are independent and uniform, and have the symmetry of a real plane.
  std::vector<float> white;
  white.reserve(std::size_t(spectrum.width) * std::size_t(spectrum.height));
  for (int y = 0; y < spectrum.height; ++y)
    for (int x = 0; x < spectrum.width; ++x)
      white.push_back(
          float(pcg3d({std::uint32_t(x), std::uint32_t(y), pcg(seed)})[0] >> 8u) * 0x1p-24f - 0.5f);
  HalfSpectrum phases = forwardFft(white, spectrum.width, spectrum.height);
  for (std::size_t i = 1; i < phases.values.size(); ++i) {
    const float modulus = std::abs(phases.values[i]);
    if (modulus > 0.0f)
      phases.values[i] *= 1.0f / modulus;
    phases.values[i] *= spectrum.values[i];
  }
  phases.values[0] = spectrum.values[0]; // keeps the mean
  return inverseFft(phases);
}

// Autocovariance of a plane (height, width) -> (2 support - 1, 2 support - 1), by the
// Wiener-Khinchin theorem on a zero-padded plane.

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
