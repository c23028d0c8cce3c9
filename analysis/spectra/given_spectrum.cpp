// SPDX-License-Identifier: MIT
// Amplitudes at frequencies -> the transform of one random field that has them. [LRP14] section
// 6.1, figure 10.
#include "given_spectrum.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace lichen::spectra {
namespace {

/// The power at a frequency of the half plane: that of both mirrors, as a field is real.
double powerAt(const SpectrumPicture& picture, int u, int v) {
  const auto at = [&](int x, int y) {
    x += picture.width / 2;
    y += picture.height / 2;
    if (x < 0 || y < 0 || x >= picture.width || y >= picture.height)
      return 0.0;
    const double amplitude =
        picture.amplitudes[std::size_t(y) * std::size_t(picture.width) + std::size_t(x)];
    return amplitude * amplitude;
  };
  return 0.5 * (at(u, v) + at(-u, -v));
}

/// Replaces one channel; returns false if the picture has no power at its frequencies.
bool replaceChannel(const SpectrumPicture& picture, double variance, std::uint32_t seed,
                    HalfSpectrum& spectrum) {
  std::mt19937 generator(seed);
  double sum = 0.0;
  for (int row = 0; row < spectrum.height; ++row) {
    const int v = spectrum.signedRow(row);
    for (int u = 0; u < spectrum.columns(); ++u) {
      // The bits as they are: distributions differ between libraries.
      const double turns = double(generator()) * 0x1p-32;
      const bool hasMirror = 2 * u < spectrum.width && 2 * std::abs(v) < spectrum.height;
      const double power = hasMirror && (u != 0 || v != 0) ? powerAt(picture, u, v) : 0.0;
      sum += spectrum.multiplicity(u) * power;
      spectrum.at(u, row) =
          std::complex<float>(std::polar(std::sqrt(power), 2.0 * std::numbers::pi * turns));
    }
  }
  if (!(sum > 0.0))
    return false;
  // Column 0 holds both mirrors.
  for (int row = spectrum.height / 2 + 1; row < spectrum.height; ++row)
    spectrum.at(0, row) = std::conj(spectrum.at(0, spectrum.height - row));
  const auto scale = float(std::sqrt(variance / sum));
  for (std::complex<float>& value : spectrum.values)
    value *= scale;
  return true;
}

} // namespace

Result<void> replaceSpectra(const SpectrumPicture& picture, std::vector<MapSpectrum>& maps) {
  std::uint32_t seed = 1;
  for (MapSpectrum& map : maps)
    for (std::size_t c = 0; c < map.channels.size(); ++c)
      if (HalfSpectrum& own = map.channels[c];
          !replaceChannel(picture, map.variances[c], seed++, own))
        return Error{ErrorKind::badInput,
                     "the spectrum has no power at the frequencies of an exemplar of " +
                         std::to_string(own.width) + " x " + std::to_string(own.height) +
                         "; expected some below " +
                         std::to_string(std::max(own.width, own.height) / 2) + " cycles per tile"};
  return {};
}

} // namespace lichen::spectra
