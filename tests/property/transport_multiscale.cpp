// SPDX-License-Identifier: MIT
// The steps of the multiscale matching, each against a slow and simple version.
#include "transport_exact.h"
#include "transport_sets.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <numeric>
#include <transport/assignment.h>
#include <transport/leaf_auction.h>
#include <transport/partition_tree.h>

using namespace lichen;
using namespace lichen::test;
using namespace lichen::transport;

namespace {

float squaredDistance(const Point& a, const Point& b) {
  const Point d{a.x - b.x, a.y - b.y, a.z - b.z};
  return dot(d, d);
}

PointArrays arrays(const Points& points) {
  PointArrays result;
  for (const Point& p : points)
    result.push_back(p);
  return result;
}

bool isPermutation(std::vector<std::uint32_t> indices, std::size_t count) {
  std::sort(indices.begin(), indices.end());
  std::vector<std::uint32_t> all(count);
  std::iota(all.begin(), all.end(), 0u);
  return indices == all;
}

} // namespace

TEST_CASE("a partition orders all points of both sets, whatever their number") {
  for (const std::size_t count : {1u, 2u, 7u, 8u, 9u, 64u, 65u, 1000u})
    for (const std::size_t leafSize : {1u, 8u})
      for (const NamedSet& source : everyKindOfSet(count, 1)) {
        const PartitionOrder order =
            partitionOrder(source.points, gaussianCloud(count, 2), leafSize);
        INFO(count << " of " << source.name << ", cells of " << leafSize);
        CHECK(isPermutation(order.source, count));
        CHECK(isPermutation(order.target, count));
      }
  CHECK(partitionOrder({}, {}, 8).source.empty());
}

TEST_CASE("a partition of a set and itself, shifted, matches every point with itself") {
  const Points source = gaussianCloud(777, 3);
  Points target = source;
  for (Point& p : target)
    p = {p.x + 1.0f, p.y, p.z};
  const PartitionOrder order = partitionOrder(source, target, 1);
  CHECK(order.source == order.target);
}

TEST_CASE("an auction among all sites ends within one increment per pair of the optimum") {
  constexpr std::size_t kCount = 200;
  for (const NamedSet& set : everyKindOfSet(kCount, 7)) {
    const Points target = gaussianCloud(kCount, 8);
    const PointArrays buyers = arrays(set.points);
    const PointArrays sites = arrays(target);
    LeafAuction auction(buyers, sites, std::vector<float>(kCount, 0.0f));
    std::vector<std::uint32_t> leaves(kCount / LeafAuction::kLeafSize);
    std::iota(leaves.begin(), leaves.end(), 0u);
    for (std::size_t group = 0; group < auction.groupCount(); ++group)
      auction.setCandidates(group, leaves);
    constexpr float kIncrement = 1e-3f;
    auction.run(kIncrement, 1000000);
    INFO(set.name);
    REQUIRE(isPermutation(auction.siteOf(), kCount));
    // Prices are sums of floats around 1: at most a thousand roundings of 2^-24.
    constexpr float kRounding = 1e-4f;
    for (std::size_t i = 0; i < kCount; ++i) {
      const std::uint32_t j = auction.siteOf()[i];
      CHECK(auction.buyerOf()[j] == i);
      // Epsilon-complementary slackness [B88].
      CHECK(squaredDistance(buyers[i], sites[j]) + auction.price(j) <=
            auction.leastCost(i) + kIncrement + kRounding);
    }
    const double best = transportCost(set.points, target, exactAssignment(set.points, target));
    const double cost = transportCost(set.points, target, auction.siteOf());
    CHECK(cost >= best * (1.0 - 1e-6));
    CHECK(cost <= best + double(kIncrement + kRounding));
  }
}

TEST_CASE("an auction assigns each site to one buyer, also when it ends early") {
  const PointArrays buyers = arrays(clusters(100, 9));
  const PointArrays sites = arrays(gaussianCloud(100, 10));
  LeafAuction auction(buyers, sites, std::vector<float>(100, 0.0f));
  const std::array<std::uint32_t, 2> leaves{3, 12}; // the last holds four sites
  for (std::size_t group = 0; group < auction.groupCount(); ++group)
    auction.setCandidates(group, leaves);
  auction.run(1e-3f, 5);
  std::size_t taken = 0;
  for (std::uint32_t i = 0; i < 100; ++i) {
    const std::uint32_t j = auction.siteOf()[i];
    if (j == kNoPartner)
      continue;
    ++taken;
    CHECK((j / 8 == 3 || (j / 8 == 12 && j < 100)));
    CHECK(auction.buyerOf()[j] == i);
  }
  CHECK(taken == 12);
}

TEST_CASE("sets of several levels are matched to within half a per cent of the targets' variance",
          "[large]") {
  // Two levels, and three of the kind with the largest excess, whose exact matching takes longest.
  for (const NamedSet& source : {NamedSet{"a Gaussian cloud", gaussianCloud(600, 11)},
                                 NamedSet{"clusters", clusters(600, 12)},
                                 NamedSet{"8-bit colours", quantizedColors(600, 13)},
                                 NamedSet{"a Gaussian cloud", gaussianCloud(2100, 11)}}) {
    const std::size_t count = source.points.size();
    const Points target = gaussianCloud(count, 14);
    const double cost = transportCost(source.points, target, assign(source.points, target, {}));
    const double best =
        transportCost(source.points, target, exactAssignment(source.points, target));
    INFO(count << " of " << source.name);
    // Relative to the variance, 3 / 36. The cost itself is no reference: between two samples of
    // one distribution it is only noise, and the matching leaves a tenth more than necessary.
    // Measured: at most 0.0038, 0.0015 and 0.0004 of the variance, in the order of the kinds.
    CHECK(cost - best < 0.005 * 3.0 / 36.0);
  }
}
