// SPDX-License-Identifier: MIT
// Values (height, width, channels) -> standard deviation of their slowest variation, from eight
// frequencies of the discrete Fourier transform.
#include "slow_variation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace lichen::suitability {
namespace {

constexpr int kSmallestSide = 8; // on a smaller side, one cycle per side is not slow

using Wave = std::vector<std::complex<double>>;

/// exp(-2 pi i (k + 1/2) / side).
Wave oneCycle(int side) {
  Wave wave(static_cast<std::size_t>(side));
  for (int k = 0; k < side; ++k)
    wave[std::size_t(k)] = std::polar(1.0, -2.0 * std::numbers::pi * (k + 0.5) / side);
  return wave;
}

/// Energy of one channel at the eight frequencies, of the transform divided by its size. `across`
/// and `down` are one cycle along each axis.
double slowEnergy(const MapExemplar& map, std::size_t channel, const Wave& across,
                  const Wave& down) {
  // Frequencies (1, 0), (0, 1), (1, 1), (1, -1); the other four are their conjugates.
  std::array<std::complex<double>, 4> sums{};
  const float* value = map.values.data() + channel;
  for (int y = 0; y < map.height; ++y) {
    double level = 0.0;
    std::complex<double> row = 0.0;
    for (int x = 0; x < map.width; ++x, value += map.channels.size()) {
      level += double(*value);
      row += double(*value) * across[std::size_t(x)];
    }
    const std::complex<double> turn = down[std::size_t(y)];
    sums[0] += row;
    sums[1] += level * turn;
    sums[2] += row * turn;
    sums[3] += row * std::conj(turn);
  }
  const double pixels = double(map.width) * double(map.height);
  double energy = 0.0;
  for (const std::complex<double>& sum : sums)
    energy += 2.0 * std::norm(sum / pixels);
  return energy;
}

double spanOf(const MapExemplar& map) {
  switch (map.encoding) {
  case ValueEncoding::srgb:
  case ValueEncoding::root:
  case ValueEncoding::linear:
  case ValueEncoding::index:
    break;
  case ValueEncoding::slope:
    return 2.0;
  case ValueEncoding::log2:
    return std::max(1.0, double(*std::max_element(map.values.begin(), map.values.end())));
  }
  return 1.0;
}

} // namespace

double slowVariation(const MapExemplar& map) {
  if (std::min(map.width, map.height) < kSmallestSide)
    return 0.0;
  const Wave across = oneCycle(map.width), down = oneCycle(map.height);
  double energy = 0.0;
  for (std::size_t c = 0; c < map.channels.size(); ++c)
    energy += slowEnergy(map, c, across, down);
  return std::sqrt(energy / double(map.channels.size()));
}

double slowVariationShare(const MapExemplar& map) { return slowVariation(map) / spanOf(map); }

} // namespace lichen::suitability
