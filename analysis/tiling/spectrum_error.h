// SPDX-License-Identifier: MIT
// How much more or less detail a noise has than its exemplar.
#pragma once

#include "gaussianize.h"
#include "inverse_table.h"

#include <lichen/tiling.h>

namespace lichen::tiling {

/// Whether the map is large enough to be measured: 64 pixels or more on both sides.
[[nodiscard]] bool hasSpectrum(const MapExemplar& map);

/// Radially averaged power of the noise over that of the exemplar, in decibels: the mean over radii
/// from 4 cycles per window up. Positive where blending adds detail. Colour counts by the luminance
/// of its code values, other maps by all channels. `table` as fitInverseTable makes it. 2^20 texels
/// of noise are sampled, in windows with constant weights. The map has a spectrum.
[[nodiscard]] double spectrumErrorDb(const MapExemplar& map, const Gaussianized& gaussian,
                                     const InverseTable& table);

} // namespace lichen::tiling
