// SPDX-License-Identifier: MIT
// Dual prices that go with a matching.
#pragma once

#include "precondition.h"

#include <vector>

namespace lichen::transport {

/// Prices of the targets at which the matching of source i to target i is nearly the cheapest, for
/// N pairs. Where it is optimal and the sets are dense, |x - y|^2 + price(y) is least at the target
/// y of x, so that grad price(y) = 2 (x - y): the prices are the least-squares solution of its
/// differences between neighbouring targets. Good within distances of neighbours of the optimal
/// prices if the matching is good; of any matching, some prices. Finite; O(N^(4/3)).
/// Source: [B91] in docs/theory.md, Brenier's theorem.
[[nodiscard]] std::vector<double> pricesOfMatching(const PointPair& pairs);

} // namespace lichen::transport
