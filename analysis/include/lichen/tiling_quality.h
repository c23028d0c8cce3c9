// SPDX-License-Identifier: MIT
// How many tiles tiling fetches: what a host of the shaders chooses by LICHEN_TILING_TAPS and
// LICHEN_ONE_TAP_TILES (shaders_glsl/noise/fewer_taps.glsl).
#pragma once

#include <lichen/bundle.h>

namespace lichen {

inline constexpr NumberRange kOneTapTilesRange{0.0, 1e6};

struct TilingQuality {
  int taps = 3; ///< 3 or 2: tiles fetched at most
  /// Pixels of this side and larger [tiles] take one, which begins at half of it; in
  /// kOneTapTilesRange, 0: none do.
  double oneTapTiles = 0.0;
};

} // namespace lichen
