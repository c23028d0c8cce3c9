// SPDX-License-Identifier: MIT
// Measures how much more or less detail a noise has than its exemplar.
#pragma once

#include "gaussianize.h"
#include "inverse_table.h"

#include <lichen/gaussianization.h>

namespace lichen::gaussianization {

/// Returns whether the map is large enough to measure: 64 pixels or more on both sides.
[[nodiscard]] bool hasSpectrum(const MapExemplar& map);

/// Returns the radially averaged power of the noise over the exemplar's in decibels, as a mean over
/// radii from 4 cycles per window upwards. Positive if blending adds detail. Colour is measured by
/// the luminance of its code values, other maps by all channels. `table` comes from
/// fitInverseTable(). Samples 2^20 texels of noise in windows with constant weights. The map must
/// have a spectrum (hasSpectrum()).
[[nodiscard]] double spectrumErrorDb(const MapExemplar& map, const Gaussianized& gaussian,
                                     const InverseTable& table);

} // namespace lichen::gaussianization
