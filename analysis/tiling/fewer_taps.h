// SPDX-License-Identifier: MIT
// Tiling with fewer fetches than three: the CPU twin of shaders_glsl/noise/fewer_taps.glsl.
#pragma once

#include "simplex_lattice.h"

#include <lichen/tile_footprint.h>
#include <lichen/tiling_quality.h>

namespace lichen::tiling {

/// Sorts the taps, the one of the most weight first, and takes weight away from all until so many
/// are 0 as the quality says; the weights sum to 1, before and after. With three taps everywhere,
/// nothing changes.
void takeFewerTaps(Taps& taps, const TileFootprint& at, const TilingQuality& quality);

} // namespace lichen::tiling
