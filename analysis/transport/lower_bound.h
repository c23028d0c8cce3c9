// SPDX-License-Identifier: MIT
// How far a matching is from the optimum: a certified lower bound of the transport cost.
#pragma once

#include "point.h"
#include "progress_part.h"

#include <lichen/transport.h>

#include <cstdint>
#include <span>

namespace lichen::transport {

/// Bounds the cost of every bijection between two sets of one size N < 2^31 by the dual of the
/// assignment problem: for any prices, sum_i min_j (|x_i - y_j|^2 + price_j) - sum_j price_j. The
/// minima are exact and float rounding is subtracted, so the bound holds whatever `assignment` is;
/// it is the closer the better `assignment` is, from whose pairs the prices are found. `tolerance`
/// in [1e-6, 1] is the step of the prices in units of centredCost: the bound ends up about half a
/// step below the optimum. On photographs, N = 65,536 and the default take about 20 s on one core.
/// Throws Interrupted and std::bad_alloc.
/// The same result for any number of threads. About 300 bytes a point.
/// Sources: auction algorithm [B88]; prices from coarse to fine [M11].
[[nodiscard]] TransportBound boundTransportCost(std::span<const Point> source,
                                                std::span<const Point> target,
                                                std::span<const std::uint32_t> assignment,
                                                double tolerance = 5e-4,
                                                ProgressPart progress = {});

} // namespace lichen::transport
