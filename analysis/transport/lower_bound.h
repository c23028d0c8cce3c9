// SPDX-License-Identifier: MIT
// A certified lower bound of the transport cost: how far a matching can be from the optimum.
#pragma once

#include "assignment.h"
#include "point.h"
#include "progress_part.h"

#include <lichen/transport.h>

#include <cstdint>
#include <span>
#include <vector>

namespace lichen::transport {

/// Bounds the cost of every bijection between two sets of the same size N < 2^31 by the dual of the
/// assignment problem. For any prices, the bound is
/// sum_i min_j (|x_i - y_j|^2 + price_j) - sum_j price_j. The minima are exact and float rounding
/// is subtracted, so the bound holds for any `assignment`. The prices start from its pairs, so a
/// better `assignment` gives a tighter bound.
/// `tolerance` in [1e-6, 1] is the price step in units of centredCost; the bound ends up about half
/// a step below the optimum. With N = 65,536 and 1e-4, photographs take about 4 s on one core and
/// sets with gaps up to 30 s. About 500 bytes per point. The result does not depend on the number
/// of threads. Throws Interrupted and std::bad_alloc.
/// Source: auction algorithm [B88], started from the matching's prices.
[[nodiscard]] TransportBound boundTransportCost(std::span<const Point> source,
                                                std::span<const Point> target,
                                                std::span<const std::uint32_t> assignment,
                                                double tolerance = 5e-4,
                                                ProgressPart progress = {});

/// Like boundTransportCost(). If the auction's own matching, repaired by exchanges, costs less than
/// `assignment`, it replaces `assignment`, and the bound refers to it.
[[nodiscard]] TransportBound improveByAuction(std::span<const Point> source,
                                              std::span<const Point> target,
                                              std::vector<std::uint32_t>& assignment,
                                              double tolerance, ProgressPart progress = {});

/// The bound for an optimal matching, such as the sorted one of points on a line: its own cost.
[[nodiscard]] TransportBound boundOfOptimum(std::span<const Point> source,
                                            std::span<const Point> target,
                                            std::span<const std::uint32_t> assignment);

} // namespace lichen::transport
