// SPDX-License-Identifier: MIT
// At which mip a pixel is fetched: the CPU twin of shaders_glsl/noise/footprint_level.glsl.
#pragma once

#include <lichen/tile_footprint.h>

namespace lichen {

/// The level at which a trilinear sampler fetches the footprint in an image of these texels a tile;
/// negative where it is magnified, and not clamped to the image's last mip.
[[nodiscard]] float footprintLevel(const TileFootprint& at, float texelsPerTileX,
                                   float texelsPerTileY);

} // namespace lichen
