// SPDX-License-Identifier: MIT
// Tests whether an exemplar tiles.
#pragma once

#include <lichen/exemplar.h>

namespace lichen::exemplar {

/// How far the line between opposite borders stands out among the lines between interior
/// neighbours, as a share of what docs/decisions/005-exemplar.md allows: at most 1 if the
/// borders fit. Boxes of 1 x 4, 1 x 16, 4 x 16, 4 x 64, ... pixels, the long side along the line,
/// are averaged on both sides of it. A line's difference is the difference of its boxes over the
/// mean of the lines within an eighth of the side around: of the whole line, or of the eighth of it
/// where this is greatest. The strength is the greatest over all boxes. It is 0 across a side under
/// 8 pixels, which has too small an interior, and infinite where only the border differs. O(N
/// log(side)) time. Throws std::bad_alloc.
struct SeamStrength {
  double betweenColumns = 0.0; ///< between the last and the first
  double betweenRows = 0.0;
};
[[nodiscard]] SeamStrength seamStrength(const MapExemplar& map);

/// Returns whether no seam is stronger than 1. 2 to 5 % of the exemplars that tile are found not to
/// (docs/decisions/005-exemplar.md). Throws std::bad_alloc.
[[nodiscard]] bool isPeriodic(const MapExemplar& map);

} // namespace lichen::exemplar
