// SPDX-License-Identifier: MIT
// Adds the variance of slopes lost to filtering to the table of a slope map.
#pragma once

#include "inverse_table.h"
#include "mip_chain.h"

#include <vector>

namespace lichen::gaussianization {

/// Appends a channel to each level of a slope map's table: the variance of a slope, (Var sx + Var
/// sy) / 2 of T^-1(g + e), with e ~ N(0, S / 36) as for the levels' means; 0 in level 0. `levels`
/// are the prefiltered levels of `table` with restored means; `gaussian` is the stored image,
/// `lost` and `losses` are the losses of its mip levels and of fetches. The true e is not quite
/// Gaussian, so one number scales each level's channel: over blended fetches of the stored mip
/// levels, its mean and the variance of the level's slopes then add up to the whole. Throws
/// std::bad_alloc.
void appendSlopeVariance(std::vector<InverseTable>& levels, const InverseTable& table,
                         const Table& gaussian, const std::vector<exemplar::ChannelMatrix>& lost,
                         const std::vector<float>& losses);

} // namespace lichen::gaussianization
