// SPDX-License-Identifier: MIT
// The mip level at which a pixel is fetched: the CPU twin of
// shaders_glsl/noise/footprint_level.glsl.
#pragma once

#include <lichen/tile_footprint.h>

namespace lichen {

/// Returns the mip level at which a trilinear sampler fetches the footprint, in an image of this
/// many texels per tile. The level is negative under magnification and is not clamped to the last
/// mip.
[[nodiscard]] float footprintLevel(const TileFootprint& at, float texelsPerTileX,
                                   float texelsPerTileY);

} // namespace lichen
