// SPDX-License-Identifier: MIT
// Another number of pixels for a map.
#pragma once

#include <lichen/material_set.h>

namespace lichen::exemplar {

/// The pixels inside `part`, which lies inside the map.
[[nodiscard]] MapExemplar cropped(const MapExemplar& map, const PixelRectangle& part);

/// The map at another size: what averages (light, slopes, data) is filtered with the cubic of
/// [MN88], stretched over the pixels that fall together when the map shrinks, and no value leaves
/// the range of the map's own. `wraps`: opposite borders continue each other; otherwise the
/// outermost pixels go on. O(pixels of the result times those under the filter); multi-threaded.
[[nodiscard]] MapExemplar resampled(const MapExemplar& map, int width, int height, bool wraps);

} // namespace lichen::exemplar
