// SPDX-License-Identifier: MIT
// The certified lower bound of the transport cost.
#include "transport_exact.h"
#include "transport_sets.h"

#include <catch2/catch.hpp>
#include <tbb/global_control.h>

#include <algorithm>
#include <numeric>
#include <transport/assignment.h>
#include <transport/lower_bound.h>

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

TEST_CASE("the bound is below the exact cost, and close to it") {
  for (unsigned seed = 1; seed <= 2; ++seed)
    for (const NamedSet& source : everyKindOfSet(150, seed)) // two levels of prices
      for (const NamedSet& target : everyKindOfSet(150, seed + 100)) {
        const std::vector<std::uint32_t> exact = exactAssignment(source.points, target.points);
        const TransportBound bound = boundTransportCost(source.points, target.points, exact);
        INFO(source.name << " to " << target.name << ", seed " << seed);
        CHECK(bound.cost == transportCost(source.points, target.points, exact));
        CHECK(bound.centredCost ==
              Approx(centredCost(source.points, target.points, exact)).margin(1e-12));
        // A few units in the last place of the sum, where the bound is the cost itself.
        CHECK(bound.lowerBound <= bound.cost * (1.0 + 1e-12));
        // Half a step of the prices, and float rounding where the optimum is near 0.
        CHECK(bound.excess() < 3e-3);
      }
}

TEST_CASE("the bound holds whatever matching it starts from") {
  for (const NamedSet& source : everyKindOfSet(300, 4)) {
    const Points target = gaussianCloud(300, 5);
    const double best =
        transportCost(source.points, target, exactAssignment(source.points, target));
    const TransportBound bound = boundTransportCost(source.points, target, unsorted(300));
    INFO(source.name);
    CHECK(bound.lowerBound <= best * (1.0 + 1e-12));
    CHECK(bound.lowerBound > 0.9 * best);
  }
}

TEST_CASE("on a line, where the sorted matching is the best, the bound reaches it") {
  constexpr std::size_t kCount = 20000;
  Points source = gaussianCloud(kCount, 6);
  Points target = clusters(kCount, 7);
  for (Points* points : {&source, &target}) {
    std::sort(points->begin(), points->end(),
              [](const Point& a, const Point& b) { return a.x < b.x; });
    for (Point& p : *points)
      p = {p.x, 0.0f, 0.0f};
  }
  const TransportBound bound = boundTransportCost(source, target, unsorted(kCount));
  CHECK(bound.lowerBound <= bound.cost);
  CHECK(bound.excess() < 1e-3);
}

TEST_CASE("a smaller step of the prices gives a closer bound") {
  const Points source = clusters(3000, 8);
  const Points target = gaussianCloud(3000, 9);
  const std::vector<std::uint32_t> assignment = assign(source, target, {});
  const TransportBound coarse = boundTransportCost(source, target, assignment, 1e-2);
  const TransportBound fine = boundTransportCost(source, target, assignment, 1e-4);
  CHECK(fine.lowerBound > coarse.lowerBound);
  CHECK(fine.lowerBound <= fine.cost);
  CHECK(fine.excess() < 5e-3);
}

TEST_CASE("sets that are one, shifted, have their distance for a bound") {
  const Points source = gaussianCloud(1000, 10);
  Points target = source;
  for (Point& p : target)
    p.x += 2.0f;
  const TransportBound bound = boundTransportCost(source, target, unsorted(1000));
  CHECK(bound.lowerBound == Approx(4.0).epsilon(1e-6));
  CHECK(boundTransportCost({}, {}, {}).lowerBound == 0.0);
  CHECK(boundTransportCost(Points{{1, 2, 3}}, Points{{1, 2, 5}}, unsorted(1)).lowerBound == 4.0);
}

TEST_CASE("one thread and two give the same bound") {
  const Points source = quantizedColors(2000, 11);
  const Points target = gaussianCloud(2000, 12);
  const std::vector<std::uint32_t> assignment = assign(source, target, {});
  const auto with = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return boundTransportCost(source, target, assignment).lowerBound;
  };
  CHECK(with(1) == with(2));
}
