// SPDX-License-Identifier: MIT
// How much edges and lines hold an image together. Random blending breaks them into pieces.
#pragma once

#include <lichen/fft.h>

namespace lichen::suitability {

/// The correlation [PS00] section 2.5 between the phase of each oriented band, one octave wide, and
/// the doubled phase of the band one octave below:
/// |mean(f conj(c^2 / |c|))| / sqrt(mean |f|^2 mean |c|^2). It is 1 if both bands meet in the same
/// edges or lines, and about 0 for random phases and for grains without outlines. The result is the
/// mean, weighted by the fine band's energy, over 4 orientations and the fine bands of period 8,
/// 16, ... pixels whose coarse band has at least 8 periods along the shorter side. Blending three
/// windows removes most of it. 0 for sides under 128 pixels.
[[nodiscard]] double phaseCoherence(const HalfSpectrum& spectrum);

} // namespace lichen::suitability
