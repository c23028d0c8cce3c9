// SPDX-License-Identifier: MIT
// A certified lower bound of the transport cost: how far a matching can be from the optimum.
#pragma once

#include <cstdint>
#include <span>
#include <transport/point.h>
#include <vector>

namespace lichen::test {

/// The cost of a matching and a certified lower bound for every matching. All in squared units of
/// the points, as means over the pairs.
struct TransportBound {
  double lowerBound = 0.0; ///< no bijection costs less
  double cost = 0.0;       ///< mean squared distance over the pairs matched
  /// `cost` minus the squared distance of the two means, which every bijection pays.
  double centredCost = 0.0;
  /// The auction's own matching: all but 0.2 % of its pairs are within a price step of optimal.
  std::vector<std::uint32_t> auctioned{};

  /// The largest part of centredCost that a better matching could save.
  [[nodiscard]] double excess() const {
    return centredCost > 0.0 ? (cost - lowerBound) / centredCost : 0.0;
  }
};

/// Bounds the cost of every bijection between two sets of the same size N < 2^26 by the dual of the
/// assignment problem. For any prices, the bound is
/// sum_i min_j (|x_i - y_j|^2 + price_j) - sum_j price_j. The minima are exact and float rounding
/// is subtracted, so the bound holds for any `assignment`. The prices start from its pairs, so a
/// better `assignment` gives a tighter bound.
/// `tolerance` in [1e-6, 1] is the price step in units of centredCost; the bound ends up about half
/// a step below the optimum. With N = 65,536 and 1e-4, photographs take about 4 s on one core and
/// sets with gaps up to 30 s. The result does not depend on the number of threads.
/// Source: auction algorithm [B88], started from the matching's prices.
[[nodiscard]] TransportBound boundTransportCost(std::span<const Point> source,
                                                std::span<const Point> target,
                                                std::span<const std::uint32_t> assignment,
                                                double tolerance = 5e-4);

} // namespace lichen::test
