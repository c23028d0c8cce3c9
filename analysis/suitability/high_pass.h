// SPDX-License-Identifier: MIT
// The filter of --flatten.
#pragma once

#include <cmath>

namespace lichen::suitability {

/// What a Gaussian low-pass that halves the amplitude at one cycle per period lets through, of a
/// frequency in cycles per period along each axis: 2^-(x^2 + y^2).
[[nodiscard]] inline double lowPassGain(double cyclesX, double cyclesY) {
  return std::exp2(-(cyclesX * cyclesX + cyclesY * cyclesY));
}

/// What removing it leaves: 0 of the mean, half at the period, 15/16 at half the period.
[[nodiscard]] inline double highPassGain(double cyclesX, double cyclesY) {
  return 1.0 - lowPassGain(cyclesX, cyclesY);
}

} // namespace lichen::suitability
