// SPDX-License-Identifier: MIT
// How much an image varies as slowly as it is large: light from one side, a vignette, one object.
#pragma once

#include <lichen/exemplar.h>

namespace lichen::suitability {

/// Standard deviation, in stored values, of the part of the image at one cycle per side: the
/// frequencies (+-1, 0), (0, +-1) and (+-1, +-1); root mean square over the channels. A ramp of
/// height d has 0.61 of its variance there: 0.225 d. 0 for sides under 8 pixels.
[[nodiscard]] double slowVariation(const MapExemplar& map);

/// The same as a share of the values that the map has nominally: 8-bit normals have components in
/// [-1, 1], and light above 1 has no limit but its own.
[[nodiscard]] double slowVariationShare(const MapExemplar& map);

} // namespace lichen::suitability
