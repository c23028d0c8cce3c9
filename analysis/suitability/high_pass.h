// SPDX-License-Identifier: MIT
// The filter of --flatten.
#pragma once

#include <cmath>

namespace lichen::suitability {

/// The gain of a Gaussian low-pass that halves the amplitude at one cycle per period:
/// 2^-(x^2 + y^2) at a frequency (x, y) in cycles per period.
[[nodiscard]] inline double lowPassGain(double cyclesX, double cyclesY) {
  return std::exp2(-(cyclesX * cyclesX + cyclesY * cyclesY));
}

/// The gain of the high-pass: 0 at the mean, 1/2 at the period, 15/16 at half the period.
[[nodiscard]] inline double highPassGain(double cyclesX, double cyclesY) {
  return 1.0 - lowPassGain(cyclesX, cyclesY);
}

} // namespace lichen::suitability
