// SPDX-License-Identifier: MIT
// How unevenly a blend of an exemplar's random windows is contrasted.
#pragma once

#include <lichen/fft.h>

namespace lichen::suitability {

/// Relative standard deviation, over the random offsets of three equally weighted taps, of the
/// variance of their blend: (2/3) sqrt(3 sum P^2 / (sum P)^2), P the power of a periodic plane of
/// unit variance without its mean. Three windows at offsets a, b, c have the blend
/// (g_a + g_b + g_c) / sqrt(3), of variance 1 + (2/3) (r(a - b) + r(a - c) + r(b - c)) with r the
/// autocorrelation; its three values are uncorrelated, and the mean of r^2 over all offsets is
/// sum P^2 / (sum P)^2 by Parseval. 0 for a plane without variance.
[[nodiscard]] double cloudiness(const HalfSpectrum& spectrum);

/// The cloudiness left if variation slower than `periodPixels` were removed by highPassGain().
[[nodiscard]] double cloudinessAbove(const HalfSpectrum& spectrum, double periodPixels);

} // namespace lichen::suitability
