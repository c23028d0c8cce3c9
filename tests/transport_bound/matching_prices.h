// SPDX-License-Identifier: MIT
// Dual prices of a matching.
#pragma once

#include <transport/precondition.h>
#include <vector>

namespace lichen::test {

/// Prices of the targets at which the matching of source i to target i, of N pairs, is nearly the
/// cheapest. If the matching is optimal and the sets are dense, |x - y|^2 + price(y) is least at
/// the target y of x, so grad price(y) = 2 (x - y). The prices fit these differences between
/// neighbouring targets by least squares. For a good matching they are as close to the optimal
/// prices as neighbours are to each other; for any other matching they are finite. O(N^(4/3)).
/// Source: [B91] in docs/theory.md, Brenier's theorem.
[[nodiscard]] std::vector<double> pricesOfMatching(const transport::PointPair& pairs);

} // namespace lichen::test
