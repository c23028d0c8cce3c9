// SPDX-License-Identifier: MIT
// An auction in which each group of buyers chooses among a few leaves of sites.
#pragma once

#include "point.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace lichen::transport {

struct PointArrays {
  std::vector<float> x;
  std::vector<float> y;
  std::vector<float> z;

  [[nodiscard]] std::size_t size() const { return x.size(); }
  [[nodiscard]] Point operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
  void push_back(const Point& p) {
    x.push_back(p.x);
    y.push_back(p.y);
    z.push_back(p.z);
  }
};

inline constexpr std::uint32_t kNoPartner = std::numeric_limits<std::uint32_t>::max();

/// Auction [B88] with cost |x_i - y_j|^2 between N buyers x and N sites y. Both are in an order in
/// which neighbours are close in space (PartitionOrder). kGroupSize successive buyers share their
/// candidates, which are whole leaves of kLeafSize successive sites, so a bid is a loop over
/// contiguous floats. Holds references to the points. Sequential.
class LeafAuction {
public:
  static constexpr std::size_t kLeafSize = 8;
  static constexpr std::size_t kGroupSize = 32;
  /// The most candidate leaves of a group. On the hardest of the benchmark's exemplars, 24 leave
  /// twice as many buyers without a site; 48 take longer and leave no fewer.
  static constexpr std::size_t kMostLeaves = 32;

  LeafAuction(const PointArrays& buyers, const PointArrays& sites, std::span<const float> prices);

  [[nodiscard]] std::size_t groupCount() const { return groups_.size(); }
  /// Sets a group's candidates to the first kMostLeaves of `leaves`, which are distinct.
  void setCandidates(std::size_t group, std::span<const std::uint32_t> leaves);

  /// Lets groups bid in turn until every buyer has a site or `rounds` are over. Each bid raises a
  /// price by at least `increment` >= 0.
  void run(float increment, int rounds);

  /// The site of each buyer, or kNoPartner.
  [[nodiscard]] const std::vector<std::uint32_t>& siteOf() const { return siteOf_; }
  [[nodiscard]] const std::vector<std::uint32_t>& buyerOf() const { return buyerOf_; }
  [[nodiscard]] float price(std::size_t site) const {
    return weight_[site] - dot(sites_[site], sites_[site]);
  }
  /// The least |x - y|^2 + price among the buyer's candidates.
  [[nodiscard]] float leastCost(std::size_t buyer) const;

private:
  struct Group {
    std::uint32_t waiting = 0; ///< bit k is set if buyer k of the group has no site
    std::uint32_t leafCount = 0;
    std::uint32_t leaves[kMostLeaves] = {};
  };
  struct Candidates;

  void visit(std::size_t group, float increment);
  void give(std::uint32_t buyer, std::uint32_t site);

  const PointArrays& buyers_;
  const PointArrays& sites_;
  /// |y|^2 + price; infinite in the empty slots of the last leaf.
  std::vector<float> weight_;
  std::vector<std::uint32_t> siteOf_;
  std::vector<std::uint32_t> buyerOf_;
  std::vector<Group> groups_;
  std::size_t waiting_ = 0;
};

} // namespace lichen::transport
