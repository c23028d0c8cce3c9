// SPDX-License-Identifier: MIT
// Whether an exemplar has a few colours with nothing between them.
#pragma once

#include <lichen/exemplar.h>

namespace lichen::suitability {

/// Of 8-bit codes.
struct FewColors {
  /// How far apart neighbouring codes are: the standard deviation over that of a normal
  /// distribution of the same entropy, which is the root of the entropy power [CT06]. 1 for normal
  /// distributions of any width; the least of the channels that vary.
  double spacing = 0.0;
  /// exp(entropy) of the colours, n for n equally frequent ones; counted only where they are so far
  /// apart that it is a risk.
  double count = 0.0;
};

/// Of base colours in sRGB code values; zeros of other maps, which may well be 0 or 1, of log2, and
/// of maps that do not vary. O(N), and O(N log N) where colours are few.
[[nodiscard]] FewColors fewColors(const MapExemplar& map);

} // namespace lichen::suitability
