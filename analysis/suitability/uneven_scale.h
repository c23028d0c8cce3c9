// SPDX-License-Identifier: MIT
// Whether a photograph shows its material at one scale: a slanted or partly blurred one does not.
#pragma once

#include <lichen/exemplar.h>

namespace lichen::suitability {

/// By how many octaves of power fine detail gains on coarse detail from one side to the other,
/// along the axis where that is more. Fine and coarse are mean squared differences of brightness at
/// 1 and 8 pixels, in eight strips of the map averaged to 256 pixels a side; the trend is linear.
/// 0 for maps other than base colours, and for sides under 128 pixels. Throws std::bad_alloc.
/// Source: docs/decisions/013-suitability.md.
[[nodiscard]] double unevenScale(const MapExemplar& map);

} // namespace lichen::suitability
