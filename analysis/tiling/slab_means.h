// SPDX-License-Identifier: MIT
// Keeps the mean colour at every distance: what prefiltering assumes to be Gaussian is not quite.
#pragma once

#include "inverse_table.h"
#include "mip_chain.h"

#include <vector>

namespace lichen::tiling {

/// Shifts each slab but the first and the last so that its lookups at blended trilinear fetches of
/// the stored `gaussian` image average to the last slab, the mean, as far as the values that are
/// shifted stay in the range of slab 0, to which they are clamped. `lost` is of that image. The
/// mips of an exemplar with few large features are far from Gaussian, which displaces the mean of
/// their decoded values by up to 0.004 of full light.
void restoreSlabMeans(std::vector<InverseTable>& slabs, const Table& gaussian,
                      const std::vector<ChannelMatrix>& lost);

} // namespace lichen::tiling
