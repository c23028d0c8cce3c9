// SPDX-License-Identifier: MIT
// How unevenly contrast varies in a blend of an exemplar's random windows.
#pragma once

#include <lichen/fft.h>

namespace lichen::suitability {

/// The relative standard deviation, over the random offsets of three equally weighted taps, of the
/// variance of their blend: (2/3) sqrt(3 sum P^2 / (sum P)^2), with P the power spectrum, without
/// its mean, of a periodic plane of unit variance.
/// Derivation: three windows at offsets a, b, c blend to (g_a + g_b + g_c) / sqrt(3), whose
/// variance is 1 + (2/3) (r(a - b) + r(a - c) + r(b - c)) with r the autocorrelation. The three
/// values of r are uncorrelated, and by Parseval the mean of r^2 over all offsets is
/// sum P^2 / (sum P)^2.
/// 0 for a plane without variance.
[[nodiscard]] double cloudiness(const HalfSpectrum& spectrum);

/// The cloudiness after highPassGain() removes variation slower than `periodPixels`.
[[nodiscard]] double cloudinessAbove(const HalfSpectrum& spectrum, double periodPixels);

} // namespace lichen::suitability
