// SPDX-License-Identifier: MIT
// The mip level at which a pixel is fetched: the CPU twin of
// shaders_glsl/noise/footprint_level.glsl.
#pragma once

#include <lichen/tile_footprint.h>

namespace lichen {

/// lichenFootprintLevel: log2 of the side of the footprint, in an image of this many texels per
/// tile, at least 0.
[[nodiscard]] float footprintLevel(const TileFootprint& at, float texelsPerTileX,
                                   float texelsPerTileY);

/// lichenSharpLevel: the mip level at which a trilinear sampler fetches it.
[[nodiscard]] float sharpLevel(float footprintLevel);

} // namespace lichen
