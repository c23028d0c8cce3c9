// SPDX-License-Identifier: MIT
// How much of a photograph is so bright or so dark that the file holds no detail there.
#pragma once

#include <lichen/exemplar.h>

namespace lichen::suitability {

/// Shares of the pixels, [0, 1].
struct ClippedShare {
  double white = 0.0; ///< all channels within half a quantum of 1, or above
  double black = 0.0; ///< all channels within half a quantum of 0, or below
};

/// Of base colours in sRGB code values. Nothing of other maps, whose 0 and 1 are values like others
/// (a metal, an unoccluded place, no glow), nor of log2, which has no white.
[[nodiscard]] ClippedShare clippedShare(const MapExemplar& map);

} // namespace lichen::suitability
