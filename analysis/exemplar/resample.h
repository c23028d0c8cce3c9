// SPDX-License-Identifier: MIT
// Changes the number of pixels of a map, and joins maps of several files.
#pragma once

#include <lichen/exemplar.h>
#include <lichen/material_set.h>

#include <span>
#include <vector>

namespace lichen::exemplar {

/// Returns the pixels inside `part`, which must lie inside the map.
[[nodiscard]] MapExemplar cropped(const MapExemplar& map, const PixelRectangle& part);

/// Returns the map at another size. It filters what averages (light, slopes, data) with the cubic
/// of [MN88], widened when the map shrinks so that it covers all source pixels. No value leaves the
/// range of the map's own. `wraps`: opposite borders continue each other; otherwise the outermost
/// pixels repeat. O(pixels of the result times pixels under the filter); multi-threaded.
[[nodiscard]] MapExemplar resampled(const MapExemplar& map, int width, int height, bool wraps);

/// Returns one map with the channels of all parts, in the order of MapChannel, at the size of the
/// largest part. A bake preserves the relation between channels of one map exactly, but between
/// maps only on average. The quantum is the finest of the parts. `wraps` as for resampled().
[[nodiscard]] MapExemplar joined(std::span<const MapExemplar> parts, bool wraps);

} // namespace lichen::exemplar
