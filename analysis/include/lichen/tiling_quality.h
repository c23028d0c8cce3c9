// SPDX-License-Identifier: MIT
// What the evaluation of a tiling noise leaves open: how tiles are blended, and how many are
// fetched, which a host of the shaders chooses by LICHEN_TILING_TAPS and LICHEN_ONE_TAP_TILES
// (shaders_glsl/noise/fewer_taps.glsl).
#pragma once

#include <lichen/bundle.h>

namespace lichen {

/// How the three taps are blended. The first is the method; the others serve comparison.
enum class BlendOperator {
  histogramPreserving, ///< [HN18] eq. 18
  variancePreserving,  ///< eq. 8 on the decoded values: no inverse table after the blend
  linear,              ///< eq. 3 on the decoded values
};

inline constexpr NumberRange kOneTapTilesRange{0.0, 1e6};

struct TilingQuality {
  int taps = 3; ///< 3 or 2: tiles fetched at most
  /// Pixels of this side and larger [tiles] take one, which begins at half of it; in
  /// kOneTapTilesRange, 0: none do.
  double oneTapTiles = 0.0;
};

struct TilingEvaluation {
  BlendOperator blend = BlendOperator::histogramPreserving;
  TilingQuality quality;
};

} // namespace lichen
