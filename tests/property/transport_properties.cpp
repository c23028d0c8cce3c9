// SPDX-License-Identifier: MIT
// Properties of every matching that assign() returns.
#include "transport_exact.h"
#include "transport_sets.h"

#include <catch2/catch.hpp>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <transport/assignment.h>
#include <transport/cycle_canceling.h>

using namespace lichen;
using namespace lichen::test;
using namespace lichen::transport;

namespace {

bool isBijection(std::vector<std::uint32_t> assignment) {
  std::sort(assignment.begin(), assignment.end());
  for (std::size_t i = 0; i < assignment.size(); ++i)
    if (assignment[i] != i)
      return false;
  return true;
}

std::vector<std::uint32_t> assignWithThreads(int threads, const Points& source,
                                             const Points& target) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  std::size_t(threads));
  return assign(source, target, {});
}

/// Points along one axis.
Points onAxis(const Points& points) {
  Points result;
  for (const Point& p : points)
    result.push_back({p.x, 0.0f, 0.0f});
  return result;
}

} // namespace

TEST_CASE("every matching is a bijection, for every pair of kinds of set and every small size") {
  for (const std::size_t count : {1u, 2u, 3u, 7u, 48u, 49u, 300u})
    for (const NamedSet& source : everyKindOfSet(count, 1))
      for (const NamedSet& target : everyKindOfSet(count, 2)) {
        INFO(count << " points: " << source.name << " to " << target.name);
        const std::vector<std::uint32_t> assignment = assign(source.points, target.points, {});
        REQUIRE(assignment.size() == count);
        CHECK(isBijection(assignment));
      }
  CHECK(assign({}, {}, {}).empty());
}

TEST_CASE("in one dimension the matching is the sorted one") {
  for (const std::size_t count : {2u, 48u, 49u, 1000u, 20000u}) {
    const Points source = onAxis(gaussianCloud(count, 3));
    const Points target = onAxis(clusters(count, 4));
    std::vector<float> from, to;
    for (std::size_t i = 0; i < count; ++i) {
      from.push_back(source[i].x);
      to.push_back(target[i].x);
    }
    std::sort(from.begin(), from.end());
    std::sort(to.begin(), to.end());
    double least = 0.0;
    for (std::size_t i = 0; i < count; ++i)
      least += (double(from[i]) - double(to[i])) * (double(from[i]) - double(to[i]));
    least /= double(count);
    INFO(count << " points");
    // Equal up to the order of the sum and pairs that float rounding cannot distinguish.
    CHECK(transportCost(source, target, assign(source, target, {})) == Approx(least).epsilon(1e-6));
  }
}

TEST_CASE("translating all points does not change the matching") {
  // Coordinates in 1/256 and a power of two of points: sums, means and shifted values are exact.
  constexpr std::size_t kCount = 4096;
  const auto onGrid = [](Points points, float shift) {
    for (Point& p : points)
      p = {std::round(p.x * 256.0f) / 256.0f + shift, std::round(p.y * 256.0f) / 256.0f - shift,
           std::round(p.z * 256.0f) / 256.0f + 2.0f * shift};
    return points;
  };
  const Points target = onGrid(gaussianCloud(kCount, 6), 0.0f);
  const std::vector<std::uint32_t> atHome = assign(onGrid(clusters(kCount, 5), 0.0f), target, {});
  CHECK(assign(onGrid(clusters(kCount, 5), 4.0f), target, {}) == atHome);
}

TEST_CASE(
    "exchanges inside blocks make the multiscale matching cheaper, and exact blocks more so") {
  for (const NamedSet& source : everyKindOfSet(3000, 7)) {
    const Points target = gaussianCloud(3000, 8);
    const auto cost = [&](int swapRounds, int exactRounds) {
      const TransportOptions options{.swapRounds = swapRounds, .exactRounds = exactRounds};
      return transportCost(source.points, target, assign(source.points, target, options));
    };
    const double start = cost(0, 0);
    const double swapped = cost(1, 0);
    INFO(source.name);
    // Exchanges compare preconditioned points, rounded to float: 2^-24 of a product of coordinates
    // around 1, relative to costs around 0.1.
    CHECK(swapped <= start * (1.0 + 1e-6));
    CHECK(cost(1, 1) <= swapped * (1.0 + 1e-6));
  }
}

TEST_CASE("the matching is never worse than its start") {
  const Points source = quantizedColors(2000, 9);
  const Points target = gaussianCloud(2000, 10);
  const std::vector<std::uint32_t> start = assign(source, target, {});
  // The rounds after assign()'s use other blocks.
  const std::vector<std::uint32_t> improved =
      improveAssignment(source, target, start, {.swapRounds = 8, .exactRounds = 8});
  CHECK(isBijection(improved));
  // As above, for rounding.
  CHECK(transportCost(source, target, improved) <=
        transportCost(source, target, start) * (1.0 + 1e-6));
}

TEST_CASE("one thread and two give the same matching, and so does a second run") {
  for (const NamedSet& source : everyKindOfSet(6000, 11)) {
    const Points target = gaussianCloud(6000, 12);
    const std::vector<std::uint32_t> alone = assignWithThreads(1, source.points, target);
    INFO(source.name);
    CHECK(assignWithThreads(2, source.points, target) == alone);
    CHECK(assignWithThreads(2, source.points, target) == alone);
  }
}

TEST_CASE("exchanges that gain only by rounding end") {
  // Two clusters. In each, the sources lie on a line and the targets on an orthogonal one, so that
  // the products of their differences are only rounding.
  const Point a{0.26726124f, 0.53452248f, 0.80178373f};
  const Point b{0.49099025f, -0.82594490f, 0.38696659f}; // orthogonal to a
  const Point c{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  const auto place = [&](float alongA, float alongB, float alongC) {
    return Point{alongA * a.x + alongB * b.x + alongC * c.x,
                 alongA * a.y + alongB * b.y + alongC * c.y,
                 alongA * a.z + alongB * b.z + alongC * c.z};
  };
  std::mt19937 generator(3);
  std::normal_distribution<float> spread(0.0f, 5.0f);
  std::vector<Point> source;
  std::vector<Point> target;
  for (int i = 0; i < 2048; ++i) {
    const float s = spread(generator);
    const float t = spread(generator);
    const bool first = i % 2 == 1;
    source.push_back(first ? place(s, 0.0f, 15.0f) : place(0.0f, s, -15.0f));
    target.push_back(first ? place(0.0f, t, 15.0f) : place(t, 0.0f, -15.0f));
  }
  CHECK(assign(source, target, TransportOptions{}).size() == source.size());
}

TEST_CASE("cycle cancelling ends and finds the optimum from the worst start, with equal points") {
  constexpr int kMostPoints = 48; // of a block of assign()
  for (int count = 3; count <= kMostPoints; ++count)
    for (int places = 2; places <= count; ++places) {
      // Positions on a circle, some with several points; each point is assigned its farthest
      // target.
      Points source, target;
      for (int i = 0; i < count; ++i) {
        const float angle = 2.0f * std::numbers::pi_v<float> * float(i % places) / float(places);
        source.push_back({std::cos(angle), std::sin(angle), 0.0f});
        target.push_back({-std::cos(angle), -std::sin(angle), 0.0f});
      }
      std::vector<std::uint32_t> index(source.size());
      std::iota(index.begin(), index.end(), 0u);
      Points solved = target;
      CycleCanceling().solve(source, solved, index);
      INFO(count << " points in " << places << " places");
      REQUIRE(isBijection(index));
      const auto products = [&](const std::vector<std::uint32_t>& assignment) {
        double sum = 0.0;
        for (std::size_t i = 0; i < source.size(); ++i)
          sum += double(dot(source[i], target[assignment[i]]));
        return sum;
      };
      // An exchange below 1e-5 of the largest, 2, counts as rounding; there is one per point.
      REQUIRE(products(index) ==
              Approx(products(exactAssignment(source, target))).margin(2e-5 * count));
    }
}
