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

TEST_CASE("the bound holds whatever matching it starts from") {
  for (const NamedSet& source : everyKindOfSet(300, 4)) {
    const Points target = gaussianCloud(300, 5);
    const double best =
        transportCost(source.points, target, exactAssignment(source.points, target));
    const TransportBound bound = boundTransportCost(source.points, target, unsorted(300));
    INFO(source.name);
    CHECK(bound.lowerBound <= best * (1.0 + 1e-12));
    // An auction's prices are within a step of the optimal ones for every pair [epsilon
    // complementary slackness]; the step is the tolerance times the starting cost.
    constexpr double kDefaultTolerance = 5e-4;
    const double start = centredCost(source.points, target, unsorted(300));
    CHECK(bound.lowerBound > best - kDefaultTolerance * start);
  }
}

TEST_CASE("on a line, where the sorted matching is the best, the bound reaches it", "[large]") {
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
  // The auction leaves some sources without a target, which get those that are left.
  std::vector<std::uint32_t> auctioned = bound.auctioned;
  std::sort(auctioned.begin(), auctioned.end());
  CHECK(auctioned == unsorted(kCount));
}

TEST_CASE("a smaller step of the prices gives a closer bound") {
  constexpr std::size_t kCount = 400;
  const Points source = clusters(kCount, 8);
  const Points target = gaussianCloud(kCount, 9);
  const std::vector<std::uint32_t> assignment = assign(source, target, {});
  const double best = transportCost(source, target, exactAssignment(source, target));
  const double centred = centredCost(source, target, assignment);
  const auto missing = [&](double tolerance) {
    const TransportBound bound = boundTransportCost(source, target, assignment, tolerance);
    CHECK(bound.lowerBound <= best * (1.0 + 1e-12));
    return (best - bound.lowerBound) / centred;
  };
  constexpr double kCoarse = 1e-2, kFine = 1e-4;
  // At most one step, plus what float coordinates may hide: kRounding + kLeftOut of
  // lower_bound.cpp, 6e-6, times twice the norms; the cost is more than an eighth of these here.
  CHECK(missing(kCoarse) < kCoarse + 1e-4);
  CHECK(missing(kFine) < kFine + 1e-4);
  CHECK(missing(kFine) < missing(kCoarse));
}

TEST_CASE("the bound of a set and its translation is their distance") {
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

TEST_CASE("a linear map between two clouds has the prices of its closed form") {
  // y = A x with A symmetric and positive definite is optimal, and grad price(y) = 2 (A^-1 y - y).
  constexpr std::size_t kCount = 3000;
  const double along = 1.5, across = 0.5, depth = 0.9;
  transport::PointPair pairs;
  pairs.source = gaussianCloud(kCount, 13);
  for (const Point& p : pairs.source)
    pairs.target.push_back({float(along * p.x), float(across * p.y), float(depth * p.z)});
  const std::vector<double> prices = pricesOfMatching(pairs);
  const auto closedForm = [&](const Point& y) {
    return (1.0 / along - 1.0) * y.x * y.x + (1.0 / across - 1.0) * y.y * y.y +
           (1.0 / depth - 1.0) * y.z * y.z;
  };
  double sum = 0.0, squares = 0.0, product = 0.0, ours = 0.0, ourSquares = 0.0;
  for (std::size_t i = 0; i < kCount; ++i) {
    const double wanted = closedForm(pairs.target[i]);
    sum += wanted;
    squares += wanted * wanted;
    ours += prices[i];
    ourSquares += prices[i] * prices[i];
    product += wanted * prices[i];
  }
  const double n = double(kCount);
  const double variance = squares / n - sum * sum / n / n;
  const double residual =
      variance + ourSquares / n - ours * ours / n / n - 2.0 * (product / n - sum * ours / n / n);
  // The trapezoidal rule is exact for it; the solver's stopping error remains: 1 % of the norm.
  INFO("residual " << residual / variance);
  CHECK(residual < 1e-3 * variance);
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
