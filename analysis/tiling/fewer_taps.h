// SPDX-License-Identifier: MIT
// Tiling with fewer than three fetches: the CPU twin of shaders_glsl/noise/fewer_taps.glsl.
#pragma once

#include "simplex_lattice.h"

#include <lichen/tile_footprint.h>
#include <lichen/tiling_quality.h>

namespace lichen::tiling {

/// Sorts the taps by weight, largest first, and reduces all weights until as many are 0 as the
/// quality asks for. The weights sum to 1 before and after. With three taps everywhere, nothing
/// changes.
void reduceTaps(Taps& taps, const TileFootprint& at, const TilingQuality& quality);

} // namespace lichen::tiling
