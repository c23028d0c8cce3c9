// SPDX-License-Identifier: MIT
// How much of a photograph is too bright or too dark to hold detail.
#pragma once

#include <lichen/exemplar.h>

namespace lichen::suitability {

/// Shares of the pixels, in [0, 1].
struct ClippedShare {
  double white = 0.0; ///< all channels within half a quantum of 1, or above
  double black = 0.0; ///< all channels within half a quantum of 0, or below
};

/// For base colours in sRGB code values. Zeros for other maps, where 0 and 1 are ordinary values
/// (metal, unoccluded, no glow), and for log2, which has no white.
[[nodiscard]] ClippedShare clippedShare(const MapExemplar& map);

} // namespace lichen::suitability
