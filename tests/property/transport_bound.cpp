// SPDX-License-Identifier: MIT
// The certified lower bound of the transport cost.
#include "transport_exact.h"
#include "transport_sets.h"

#include <catch2/catch.hpp>
#include <tbb/global_control.h>

#include <algorithm>
#include <lower_bound.h>
#include <matching_prices.h>
#include <numeric>
#include <transport/assignment.h>

using namespace lichen;
using namespace lichen::test;
using namespace lichen::transport;

namespace {

std::vector<std::uint32_t> unsorted(std::size_t count) {
  std::vector<std::uint32_t> assignment(count);
  std::iota(assignment.begin(), assignment.end(), 0u);
  return assignment;
}

} // namespace

TEST_CASE("the bound is below the exact cost, and close to it", "[large]") {
  for (unsigned seed = 1; seed <= 2; ++seed)
    for (const NamedSet& source : everyKindOfSet(150, seed)) // two levels of prices
      for (const NamedSet& target : everyKindOfSet(150, seed + 100)) {
        const std::vector<std::uint32_t> exact = exactAssignment(source.points, target.points);
        const TransportBound bound = boundTransportCost(source.points, target.points, exact);
        INFO(source.name << " to " << target.name << ", seed " << seed);
        CHECK(bound.cost == transportCost(source.points, target.points, exact));
        CHECK(bound.centredCost ==
              Approx(centredCost(source.points, target.points, exact)).margin(1e-12));
        // A few units in the last place of the sum, for sets whose cost equals the bound.
        CHECK(bound.lowerBound <= bound.cost * (1.0 + 1e-12));
        // Half a price step, plus float rounding where the optimum is near 0.
        CHECK(bound.excess() < 3e-3);
      }
}

TEST_CASE("an auction makes any matching nearly optimal, and bounds the remaining error") {
  for (const NamedSet& source : everyKindOfSet(300, 14)) {
    const Points target = gaussianCloud(300, 15);
    const std::vector<std::uint32_t> exact = exactAssignment(source.points, target);
    std::vector<std::uint32_t> assignment = unsorted(300);
    std::reverse(assignment.begin(), assignment.end());
    const double start = centredCost(source.points, target, assignment);
    const TransportBound bound = boundTransportCost(source.points, target, assignment, 1e-3);
    const double cost = transportCost(source.points, target, bound.auctioned);
    INFO(source.name);
    CHECK(std::is_permutation(bound.auctioned.begin(), bound.auctioned.end(), exact.begin()));
    CHECK(bound.lowerBound <= transportCost(source.points, target, exact) * (1.0 + 1e-12));
    // Two steps of the starting cost: one for the auction's error, one for its bound.
    CHECK(cost - bound.lowerBound < 2e-3 * start);
  }
}
