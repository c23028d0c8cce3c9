// SPDX-License-Identifier: MIT
// Whether an exemplar has a few colours with nothing between them.
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

} // namespace lichen::suitability
