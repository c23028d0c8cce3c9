// SPDX-License-Identifier: MIT
// Evaluation options of a tiling noise: how tiles are blended, and how many of them and of the
// table's mip levels are fetched. In the shaders a host sets them by LICHEN_TILING_TAPS,
// LICHEN_ONE_TAP_TILES (shaders_glsl/noise/fewer_taps.glsl) and LICHEN_NEAREST_TABLE_LEVEL
// (shaders_glsl/noise/decode.glsl).
#pragma once

#include <lichen/bundle.h>

namespace lichen {

/// How the three taps are blended. The first is the method; the others are for comparison.
enum class BlendOperator {
  histogramPreserving, ///< [HN18] eq. 18
  variancePreserving,  ///< eq. 8 on the decoded values: no inverse table after the blend
  linear,              ///< eq. 3 on the decoded values
};

inline constexpr NumberRange kOneTapTilesRange{0.0, 1e6};

struct TilingQuality {
  int taps = 3; ///< maximum number of tiles fetched: 3 or 2
  /// Pixels with at least this side [tiles] fetch one tile; the transition begins at half of it. In
  /// kOneTapTilesRange; 0: no pixel does.
  double oneTapTiles = 0.0;
  bool nearestTableLevel = false; ///< fetch one mip level of a table instead of blending two
};

} // namespace lichen
