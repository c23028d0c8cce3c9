// SPDX-License-Identifier: MIT
// Whether a photograph shows its material at one scale: a slanted or partly blurred one does not.
#pragma once

#include <lichen/exemplar.h>

namespace lichen::suitability {

/// By how many octaves of power fine detail gains on coarse detail from one side to the other,
/// along the axis where that is more. Fine and coarse are mean squared differences of brightness at
/// 1 and 8 pixels, in eight strips of the map; the trend is linear. A pixel is a 256th of the
/// shorter side, over which the map is averaged, so a larger map of the same picture has about the
/// same result. A smaller one is measured by its own pixels.
/// 0 for maps other than base colours, and for sides under 128 pixels. Throws std::bad_alloc.
/// Source: docs/decisions/007-verdicts.md.
[[nodiscard]] double unevenScale(const MapExemplar& map);

} // namespace lichen::suitability
