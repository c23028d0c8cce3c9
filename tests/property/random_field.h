// SPDX-License-Identifier: MIT
// Fields of random phases.
#pragma once

#include <lichen/fft.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

namespace lichen::test {

/// A periodic plane of side x side values with the mean 0, the variance 1, random phases and the
/// power `power(u, v)` at whole frequencies [cycles / tile].
template <class Power>
std::vector<float> randomField(int side, const Power& power, std::uint32_t seed) {
  HalfSpectrum spectrum{side, side, {}};
  spectrum.values.resize(std::size_t(spectrum.columns()) * std::size_t(side));
  std::mt19937 generator(seed);
  double sum = 0.0;
  for (int row = 0; row < side; ++row)
    for (int u = 0; u < spectrum.columns(); ++u) {
      const double value = u == 0 && row == 0 ? 0.0 : double(power(u, spectrum.signedRow(row)));
      const double phase = 2.0 * std::numbers::pi * double(generator()) * 0x1p-32;
      sum += spectrum.multiplicity(u) * value;
      spectrum.at(u, row) = std::complex<float>(std::polar(std::sqrt(value), phase));
    }
  for (int row = side / 2 + 1; row < side; ++row)
    spectrum.at(0, row) = std::conj(spectrum.at(0, side - row));
  std::vector<float> field = inverseFft(spectrum);
  for (float& value : field)
    value *= float(double(side) * side / std::sqrt(sum));
  return field;
}

/// A power that falls like a bell to exp(-1/2) at `radius` cycles per tile.
inline auto bellPower(double radius) {
  return [radius](int u, int v) {
    return std::exp(-0.5 * (double(u) * u + double(v) * v) / (radius * radius));
  };
}

} // namespace lichen::test
