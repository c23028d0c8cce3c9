// SPDX-License-Identifier: MIT
// Power spectrum of a plane (height, width / 2 + 1) -> contrast variation of its random blends.
// Source: [HN18] section 5.3 on stationarity; the header derives the closed form.
#include "cloudiness.h"

#include "high_pass.h"

#include <cmath>

namespace lichen::suitability {
namespace {

template <typename GainAt>
double cloudinessOf(const HalfSpectrum& spectrum, const GainAt& gainAt) {
  double sum = 0.0, squares = 0.0;
  for (int v = 0; v < spectrum.height; ++v)
    for (int u = 0; u < spectrum.columns(); ++u) {
      if (u == 0 && v == 0)
        continue;
      const double gain = gainAt(u, v);
      const double power = gain * gain * double(std::norm(spectrum.at(u, v)));
      sum += spectrum.multiplicity(u) * power;
      squares += spectrum.multiplicity(u) * power * power;
    }
  return sum > 0.0 ? 2.0 / 3.0 * std::sqrt(3.0 * squares) / sum : 0.0;
}

} // namespace

double cloudiness(const HalfSpectrum& spectrum) {
  return cloudinessOf(spectrum, [](int, int) { return 1.0; });
}

double cloudinessAbove(const HalfSpectrum& spectrum, double periodPixels) {
  return cloudinessOf(spectrum, [&](int u, int v) {
    const int signedV = spectrum.signedRow(v);
    return highPassGain(periodPixels * u / spectrum.width,
                        periodPixels * signedV / spectrum.height);
  });
}

} // namespace lichen::suitability
