// SPDX-License-Identifier: MIT
// How much an image varies at the scale of its size: light from one side, a vignette, one object.
#pragma once

#include <lichen/exemplar.h>

namespace lichen::suitability {

/// The standard deviation, in stored values, of the part of the image at one cycle per side: the
/// frequencies (+-1, 0), (0, +-1) and (+-1, +-1); root mean square over the channels. A ramp of
/// height d has 0.61 of its variance there, which gives 0.225 d. 0 for sides under 8 pixels.
[[nodiscard]] double slowVariation(const MapExemplar& map);

/// The same as a share of the map's nominal range. Components of 8-bit normals are in [-1, 1];
/// light above 1 has no limit but its own maximum.
[[nodiscard]] double slowVariationShare(const MapExemplar& map);

} // namespace lichen::suitability
