// SPDX-License-Identifier: MIT
// Whether the noise of an exemplar shows patches of the exemplar's size.
#pragma once

#include "calibration.h"

#include <lichen/exemplar.h>

namespace lichen::suitability {

/// Patches in the noise of a colour map. They show best from so far away that the exemplar covers
/// 32 pixels: nearer, grain hides them; farther, they are small themselves.
struct Patches {
  /// Standard deviation, in sRGB codes from 0 to 1, root mean square over the channels. Its square
  /// is the power of the eight waves of one cycle per side, (+-1, 0), (0, +-1) and (+-1, +-1), less
  /// twice the power of eight average waves of four cycles per side: a material's own variation has
  /// slow waves too, which chance makes twice as strong as others in 1 of 20 exemplars.
  double deviation = 0.0;
  double share = 0.0; ///< the deviation over all deviation that shows from this far

  [[nodiscard]] bool areVisible() const {
    return deviation >= kVisiblePatches && share >= kVisiblePatchShare;
  }
};

/// Zeros for sides under 16 pixels. Throws std::bad_alloc.
[[nodiscard]] Patches patchesOf(const MapExemplar& map);

} // namespace lichen::suitability
