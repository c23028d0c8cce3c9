// SPDX-License-Identifier: MIT
// How far edges and lines hold together, which random blending breaks into pieces.
#pragma once

#include <lichen/fft.h>

namespace lichen::suitability {

/// Correlation between the phase of each oriented band an octave wide and the doubled phase of the
/// band an octave below, |mean(f conj(c^2 / |c|))| / sqrt(mean |f|^2 mean |c|^2): 1 where both
/// meet in the same edges or lines, about 0 for random phases and for grains without outlines
/// [PS00] section 2.5. Mean over 4 orientations and the fine bands of period 8, 16, ... pixels
/// whose coarse one has at least 8 periods along the shorter side, weighted by the fine band's
/// energy. Blending three windows takes most of it away. 0 for sides under 128 pixels.
[[nodiscard]] double phaseCoherence(const HalfSpectrum& spectrum);

} // namespace lichen::suitability
