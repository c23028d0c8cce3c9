// SPDX-License-Identifier: MIT
// What the colours of a photograph say against random blending: they are few, or clipped.
#pragma once

#include <lichen/exemplar.h>

namespace lichen::suitability {

/// Both members are of 8-bit codes.
struct FewColors {
  /// The gap between neighbouring codes: the standard deviation divided by the deviation of a
  /// normal distribution of the same entropy, which is the root of the entropy power [CT06]. 1 for
  /// a normal distribution of any width. The least over the channels that vary.
  double spacing = 0.0;
  /// exp(entropy) of the colours: n for n equally frequent colours. Counted only if `spacing` is
  /// large enough to be a risk.
  double count = 0.0;
};

/// For base colours in sRGB code values. Zeros for other maps, which may well hold only 0 and 1,
/// for log2, and for maps that do not vary. O(N), and O(N log N) if there are few colours.
[[nodiscard]] FewColors fewColors(const MapExemplar& map);

/// Shares of the pixels, in [0, 1].
struct ClippedShare {
  double white = 0.0; ///< all channels within half a quantum of 1, or above
  double black = 0.0; ///< all channels within half a quantum of 0, or below
};

/// For base colours in sRGB code values. Zeros for other maps, where 0 and 1 are ordinary values
/// (metal, unoccluded, no glow), and for log2, which has no white.
[[nodiscard]] ClippedShare clippedShare(const MapExemplar& map);

} // namespace lichen::suitability
