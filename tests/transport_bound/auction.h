// SPDX-License-Identifier: MIT
// Dual prices of the assignment problem by auction.
#pragma once

#include "price_tree.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace lichen::test {

/// Lets buyers bid for their cheapest site until nearly all own one [B88]. Each bid raises a price
/// in `sites` by at least `increment` > 0, towards prices at which every buyer has a different
/// cheapest site. There are as many buyers as sites. Returns the site of each buyer, which is its
/// cheapest to within `increment`, or nothing for the few buyers left over. Only the first searches
/// run in parallel, so the result does not depend on the number of threads.
std::vector<std::optional<std::uint32_t>> runAuction(std::span<const Point> buyers,
                                                     PriceTree& sites, double increment);

} // namespace lichen::test
