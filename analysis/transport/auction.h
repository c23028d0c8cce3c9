// SPDX-License-Identifier: MIT
// Dual prices of the assignment problem by auction.
#pragma once

#include "point.h"
#include "price_tree.h"
#include "progress_part.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace lichen::transport {

/// Buyers bid for their cheapest site until nearly all have one [B88]: raises the prices
/// in `sites` towards those at which every buyer's cheapest site is another, by at least
/// `increment` > 0 a bid. As many buyers as sites. Returns the site of each buyer, its cheapest to
/// within `increment`, or nothing for the few that are left over. Sequential but for the first
/// searches, so the result does not depend on the number of threads. Throws Interrupted.
std::vector<std::optional<std::uint32_t>> runAuction(std::span<const Point> buyers,
                                                     PriceTree& sites, double increment,
                                                     const ProgressPart& progress);

} // namespace lichen::transport
