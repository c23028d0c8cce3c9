// SPDX-License-Identifier: MIT
// A nearly optimal matching from coarse to fine.
#pragma once

#include "precondition.h"
#include "progress_part.h"

#include <cstdint>
#include <vector>

namespace lichen::transport {

/// Matches cells of points before points: both sets are partitioned alike into cells of 8, the
/// cells' centroids are matched likewise, and the prices found there start an auction among the
/// points, in which a buyer chooses among the sites in and around its cell's match. Some tenths of
/// a per cent above the optimum, most of it within reach of local exchanges. Returns p with source
/// i matched to target p[i]. O(N log N); the same result for any number of threads.
/// Sources: multiscale transport with candidates from the coarser solution [S16], auction
/// [B88].
[[nodiscard]] std::vector<std::uint32_t> multiscaleMatching(const PointPair& points,
                                                            ProgressPart progress);

} // namespace lichen::transport
