// SPDX-License-Identifier: MIT
// Plane (height, width) -> the low-passed plane.
#include "low_pass.h"

#include "high_pass.h"

#include <lichen/fft.h>

#include <cstddef>
#include <iterator>

namespace lichen::suitability {
namespace {

/// Filters a plane that repeats.
Plane filtered(const Plane& plane, const Period& period) {
  HalfSpectrum spectrum = forwardFft(plane.values, plane.width, plane.height);
  for (int v = 0; v < spectrum.height; ++v) {
    const int signedV = spectrum.signedRow(v);
    for (int u = 0; u < spectrum.columns(); ++u)
      spectrum.at(u, v) *=
          float(lowPassGain(period.x * u / spectrum.width, period.y * signedV / spectrum.height));
  }
  return {plane.width, plane.height, inverseFft(spectrum)};
}

} // namespace

Plane mirrored(const Plane& plane) {
  Plane whole{2 * plane.width, 2 * plane.height, {}};
  whole.values.reserve(4 * plane.values.size());
  for (int y = 0; y < whole.height; ++y) {
    const int from = y < plane.height ? y : whole.height - 1 - y;
    const auto row = plane.values.begin() + std::ptrdiff_t(from) * plane.width;
    whole.values.insert(whole.values.end(), row, row + plane.width);
    whole.values.insert(whole.values.end(), std::make_reverse_iterator(row + plane.width),
                        std::make_reverse_iterator(row));
  }
  return whole;
}

Plane lowPassed(const Plane& plane, Plane trend, const Period& period, bool periodic) {
  Plane rest = plane;
  for (std::size_t i = 0; i < rest.values.size(); ++i)
    rest.values[i] -= trend.values[i];
  const Plane low = filtered(periodic ? rest : mirrored(rest), period);
  for (int y = 0; y < plane.height; ++y)
    for (int x = 0; x < plane.width; ++x)
      trend.values[std::size_t(y) * std::size_t(plane.width) + std::size_t(x)] +=
          low.values[std::size_t(y) * std::size_t(low.width) + std::size_t(x)];
  return trend;
}

} // namespace lichen::suitability
