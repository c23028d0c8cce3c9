// SPDX-License-Identifier: MIT
// The distribution function of Gaussian values, as evaluators approximate it.
#pragma once

#include <algorithm>

namespace lichen::gaussianization {

/// The CPU twin of lichenGaussianCdf: within 1.9e-4 of gaussianCdf() between the centres of the
/// outermost of 256 cells, and constant beyond them.
[[nodiscard]] inline float polynomialCdf(float gaussian) {
  constexpr float kReach = 0.48083f;
  const float x = std::clamp(gaussian - 0.5f, -kReach, kReach);
  const float q = x * x;
  return 0.5f + x * (2.3890824f + q * (-13.9188528f +
                                       q * (65.2096975f + q * (-182.1468761f + q * 220.6686413f))));
}

} // namespace lichen::gaussianization
