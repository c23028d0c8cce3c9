// SPDX-License-Identifier: MIT
// A nearly optimal matching, from coarse to fine.
#pragma once

#include "precondition.h"
#include "progress_part.h"

#include <cstdint>
#include <vector>

namespace lichen::transport {

/// Matches cells of points before points. The same partition cuts both sets into cells of 8, and
/// the cells' centroids are matched recursively. The resulting prices start an auction among the
/// points, in which a buyer chooses among the sites in and around its cell's match. The cost is
/// some tenths of a per cent above the optimum; local exchanges remove most of that. Returns p,
/// which matches source i to target p[i]. O(N log N). The result does not depend on the number of
/// threads.
/// Sources: multiscale transport with candidates from the coarser solution [S16], auction [B88].
[[nodiscard]] std::vector<std::uint32_t> multiscaleMatching(const PointPair& points,
                                                            ProgressPart progress);

} // namespace lichen::transport
