// SPDX-License-Identifier: MIT
// A plane (height, width) with a given power spectrum and random phases.
//
// Source: [GGM11].
#include <lichen/fft.h>
#include <lichen/lattice.h>
#include <lichen/spectrum.h>

#include <cmath>

namespace lichen {

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

} // namespace lichen
