// SPDX-License-Identifier: MIT
// Synthetic texton noises for the tests: random coefficients under a bell, the mips of their frames
// and the lost variance, by direct sums. They are not baked: only evaluation is tested with them.
#pragma once

#include <lichen/bundle_writer.h>

#include <span>
#include <vector>

namespace lichen::test {

struct SyntheticTexton {
  int coefficientsX = 21; ///< odd, no multiple of a coarse texel: reveals errors of the frame
  int coefficientsY = 18;
  int order = 1;
  int mipLevels = 3;
  int texelsPerTileX = 64;
  int texelsPerTileY = 48;
  int steps = 1;
  int channels = 3; ///< of the only map: 3 baseColor, sRGB; 2 normal, slopes; 1 height, linear
  bool wholeFloats = false;                  ///< 32-bit texels instead of 16-bit ones
  std::size_t lossLevels = kMaxTextonLosses; ///< levels of the lost variance
  int smoothings = 0;      ///< how often each coefficient is averaged with its neighbours
  double deviation = 0.08; ///< standard deviation of the stored values at the first step; each
                           ///< later step adds half of it
};

/// Returns the coefficients of a step, unscaled: channel c of (x, y) at ((y * X) + x) * channels +
/// c. The noise sum b(k - l) alpha(k) alpha(l)^T has the covariance that covarianceAt() returns.
[[nodiscard]] std::vector<double> syntheticCoefficients(const SyntheticTexton& texton, int step);

/// [GLM17] section 4.1: sum over k, l of b(k - l + lag) alpha(k) alpha(l)^T for a lag in texels;
/// channels x channels, row-major.
[[nodiscard]] std::vector<double> covarianceAt(const SyntheticTexton& texton,
                                               std::span<const double> coefficients, int lagX,
                                               int lagY);

/// One noise with one map and one material that uses it.
[[nodiscard]] BundleFile syntheticTextonBundle(const SyntheticTexton& texton);

/// That bundle as a GLB file.
[[nodiscard]] std::vector<std::byte> syntheticTextonGlb(const SyntheticTexton& texton);

} // namespace lichen::test
