// SPDX-License-Identifier: MIT
// The periodic component of a plane (height, width): the plane minus a smooth plane whose Laplacian
// is the jumps across the borders. Takes one forward and one inverse transform.
//
// Source: [M11], algorithm 1.
#include <lichen/fft.h>
#include <lichen/spectrum.h>

#include <cassert>
#include <cmath>
#include <numbers>

namespace lichen {
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

} // namespace lichen
