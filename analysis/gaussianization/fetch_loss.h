// SPDX-License-Identifier: MIT
// How much variance a trilinear fetch of the Gaussian image loses.
#pragma once

#include <lichen/table.h>

#include <vector>

namespace lichen::gaussianization {

/// The share of the variance of level 0 that a trilinear fetch loses, one value for each mip level,
/// in [0, 1] and never decreasing: interpolated linearly between the levels it is, in the least
/// squares, what fetches at all positions between texels lose on average. Level 0 has exactly the
/// loss of a bilinear fetch. `dimensions` of the table's channels count. Throws std::bad_alloc.
[[nodiscard]] std::vector<double> fetchLoss(const Table& gaussian, int dimensions);

} // namespace lichen::gaussianization
