// SPDX-License-Identifier: MIT
// Changes the number of pixels of a map.
#pragma once

#include <lichen/material_set.h>

namespace lichen::exemplar {

/// Returns the pixels inside `part`, which must lie inside the map.
[[nodiscard]] MapExemplar cropped(const MapExemplar& map, const PixelRectangle& part);

/// Returns the map at another size. It filters what averages (light, slopes, data) with the cubic
/// of [MN88], widened when the map shrinks so that it covers all source pixels. No value leaves the
/// range of the map's own. `wraps`: opposite borders continue each other; otherwise the outermost
/// pixels repeat. O(pixels of the result times pixels under the filter); multi-threaded.
[[nodiscard]] MapExemplar resampled(const MapExemplar& map, int width, int height, bool wraps);

} // namespace lichen::exemplar
