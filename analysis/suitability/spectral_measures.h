// SPDX-License-Identifier: MIT
// What a spectrum says against random blending: clouds, lattices, and outlines.
#pragma once

#include <lichen/fft.h>

#include <optional>

namespace lichen::suitability {

/// The relative standard deviation, over the random offsets of three equally weighted taps, of the
/// variance of their blend: (2/3) sqrt(3 sum P^2 / (sum P)^2), with P the power spectrum, without
/// its mean, of a periodic plane of unit variance.
/// Derivation: three windows at offsets a, b, c blend to (g_a + g_b + g_c) / sqrt(3), whose
/// variance is 1 + (2/3) (r(a - b) + r(a - c) + r(b - c)) with r the autocorrelation. The three
/// values of r are uncorrelated, and by Parseval the mean of r^2 over all offsets is
/// sum P^2 / (sum P)^2.
/// 0 for a plane without variance. With a `longestPeriod` [pixels], after a high-pass at this
/// period, 1 - lowPassGain().
[[nodiscard]] double cloudiness(const HalfSpectrum& spectrum,
                                std::optional<double> longestPeriod = {});

/// The share of the variance in spectral lines, in [0, 1]. A line is a frequency with more than 20
/// times the median power of the 9 x 9 frequencies around it, and than three of the eight before
/// and of the eight after it in its own direction: streaks have all frequencies of one direction.
/// Only frequencies from 5 cycles per image up count: slower ones have too few repeats to tell them
/// from clouds. With random phases, a periodogram exceeds its median r times with probability 2^-r,
/// so one frequency in a million is a line by chance. 0 for images under 32 pixels a side.
[[nodiscard]] double latticeShare(const HalfSpectrum& spectrum);

/// The correlation [PS00] section 2.5 between the phase of each oriented band, one octave wide, and
/// the doubled phase of the band one octave below:
/// |mean(f conj(c^2 / |c|))| / sqrt(mean |f|^2 mean |c|^2). It is 1 if both bands meet in the same
/// edges or lines, and about 0 for random phases and for grains without outlines. The result is the
/// mean, weighted by the fine band's energy, over 4 orientations and the fine bands of period 8,
/// 16, ... pixels whose coarse band has at least 8 periods along the shorter side. Blending three
/// windows removes most of it. 0 for sides under 128 pixels.
[[nodiscard]] double phaseCoherence(const HalfSpectrum& spectrum);

} // namespace lichen::suitability
