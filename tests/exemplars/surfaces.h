// SPDX-License-Identifier: MIT
// Plain surfaces as people photograph them: fine, dark or streaked, with little contrast, so that
// light and objects show. Literals are art direction, as in materials.h.
#pragma once

#include <lichen/image.h>

namespace lichen::exemplars {

/// Each function generates a square, opaque RGB picture of `sidePixels` pixels per side,
/// rounded to 8 bits. Details keep their size in pixels. The result is deterministic.
[[nodiscard]] SrgbImage plaster(int sidePixels);   ///< fine pale grain
[[nodiscard]] SrgbImage cloth(int sidePixels);     ///< dark matted fibres
[[nodiscard]] SrgbImage woodGrain(int sidePixels); ///< streaks of some hundred pixels, and pores
[[nodiscard]] SrgbImage concrete(int sidePixels);  ///< grey, with pores and cloudy cement

} // namespace lichen::exemplars
