// SPDX-License-Identifier: MIT
// How far a matching is from the optimum: a certified lower bound of the transport cost.
#pragma once

#include "assignment.h"
#include "point.h"
#include "progress_part.h"

#include <lichen/transport.h>

#include <cstdint>
#include <span>
#include <vector>

namespace lichen::transport {

/// Bounds the cost of every bijection between two sets of one size N < 2^31 by the dual of the
/// assignment problem: for any prices, sum_i min_j (|x_i - y_j|^2 + price_j) - sum_j price_j. The
/// minima are exact and float rounding is subtracted, so the bound holds whatever `assignment` is;
/// it is the closer the better `assignment` is, from whose pairs the prices are found. `tolerance`
/// in [1e-6, 1] is the step of the prices in units of centredCost: the bound ends up about half a
/// step below the optimum. On photographs, N = 65,536 and 1e-4 take about 4 s on one core, on sets
/// with gaps up to 30 s. Throws Interrupted and std::bad_alloc.
/// The same result for any number of threads. About 500 bytes a point.
/// Source: auction algorithm [B88], from the prices of the matching.
[[nodiscard]] TransportBound boundTransportCost(std::span<const Point> source,
                                                std::span<const Point> target,
                                                std::span<const std::uint32_t> assignment,
                                                double tolerance = 5e-4,
                                                ProgressPart progress = {});

/// As above; and where the matching that the auction itself makes, mended by exchanges, costs less
/// than `assignment`, it takes its place, and the bound is stated for it.
[[nodiscard]] TransportBound improveByAuction(std::span<const Point> source,
                                              std::span<const Point> target,
                                              std::vector<std::uint32_t>& assignment,
                                              double tolerance, ProgressPart progress = {});

/// Of a matching that is known to be optimal, as the sorted one of points on a line: its own cost.
[[nodiscard]] TransportBound boundOfOptimum(std::span<const Point> source,
                                            std::span<const Point> target,
                                            std::span<const std::uint32_t> assignment);

} // namespace lichen::transport
