// SPDX-License-Identifier: MIT
// What a slope map's table says about the slopes that a footprint hides.
#pragma once

#include "inverse_table.h"
#include "mip_chain.h"

#include <vector>

namespace lichen::tiling {

/// Appends a channel to each slab: the variance of a slope, (Var sx + Var sy) / 2 of T^-1(g + e),
/// e ~ N(0, S / 36) as for the slabs' means; 0 in slab 0, the whole decoded variance in the last.
/// `slabs` are `table` prefiltered, their means restored; `gaussian` is the stored image and `lost`
/// its. What e takes for Gaussian is not quite, so each slab's channel is scaled by one number:
/// over blended fetches of the stored mips, its mean and the variance of the slab's slopes then add
/// up to the whole. Throws std::bad_alloc.
void appendSlopeVariance(std::vector<InverseTable>& slabs, const InverseTable& table,
                         const Table& gaussian, const std::vector<exemplar::ChannelMatrix>& lost);

} // namespace lichen::tiling
