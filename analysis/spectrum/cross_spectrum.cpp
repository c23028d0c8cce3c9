// SPDX-License-Identifier: MIT
// Fourier transforms of planes (height, width) -> their periodograms, per frequency.
#include <lichen/fft.h>
#include <lichen/spectrum.h>

#include <cassert>

namespace lichen {

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

} // namespace lichen
