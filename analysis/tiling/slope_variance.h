// SPDX-License-Identifier: MIT
// Adds the variance of slopes lost to filtering to the table of a slope map.
#pragma once

#include "inverse_table.h"
#include "mip_chain.h"

#include <vector>

namespace lichen::tiling {

/// Appends a channel to each slab: the variance of a slope, (Var sx + Var sy) / 2 of T^-1(g + e),
/// with e ~ N(0, S / 36) as for the slabs' means. It is 0 in slab 0 and the whole decoded variance
/// in the last slab. `slabs` are the prefiltered slabs of `table` with restored means; `gaussian`
/// is the stored image and `lost` holds the losses of its mip levels. The true e is not quite
/// Gaussian, so one number scales each slab's channel: over blended fetches of the stored mip
/// levels, its mean and the variance of the slab's slopes then add up to the whole. Throws
/// std::bad_alloc.
void appendSlopeVariance(std::vector<InverseTable>& slabs, const InverseTable& table,
                         const Table& gaussian, const std::vector<exemplar::ChannelMatrix>& lost);

} // namespace lichen::tiling
