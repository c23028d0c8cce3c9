// SPDX-License-Identifier: MIT
// Auction over leaves of sites: N buyers, N sites and prices -> most of a matching, and new prices.
// |x - y|^2 + price = |x|^2 + (|y|^2 + price) - 2 <x, y>; a buyer compares only the last two terms.
#include "leaf_auction.h"

#include <algorithm>
#include <array>
#include <bit>

namespace lichen::transport {
namespace {

constexpr float kInfinite = std::numeric_limits<float>::infinity();

/// Sites compared at once: one AVX-512 vector or two AVX2 vectors.
constexpr std::size_t kLanes = 16;

/// Average bids per waiting buyer in one visit to its group. Without a limit, a group would raise
/// the prices around it before its neighbours bid.
constexpr int kBidsAVisit = 4;

struct Choice {
  std::size_t place = 0;
  float cost = kInfinite;
  float nextCost = kInfinite;
};

/// The least and second least of weight - 2 <x, site> over `count` sites, a multiple of kLanes.
__attribute__((target_clones("avx512f", "avx2", "default"))) Choice
choose(const float* x, const float* y, const float* z, const float* weight, std::size_t count,
       const Point& twice) {
  alignas(64) float least[kLanes], next[kLanes];
  alignas(64) std::int32_t place[kLanes];
  for (std::size_t k = 0; k < kLanes; ++k) {
    least[k] = next[k] = kInfinite;
    place[k] = 0;
  }
  for (std::size_t first = 0; first < count; first += kLanes)
    for (std::size_t k = 0; k < kLanes; ++k) {
      const std::size_t j = first + k;
      const float cost = weight[j] - (twice.x * x[j] + twice.y * y[j] + twice.z * z[j]);
      const float higher = cost > least[k] ? cost : least[k];
      next[k] = higher < next[k] ? higher : next[k];
      place[k] = cost < least[k] ? std::int32_t(j) : place[k];
      least[k] = cost < least[k] ? cost : least[k];
    }
  Choice choice;
  for (std::size_t k = 0; k < kLanes; ++k) {
    if (least[k] < choice.cost) {
      choice.nextCost = std::min(choice.cost, next[k]);
      choice.cost = least[k];
      choice.place = std::size_t(place[k]);
    } else {
      choice.nextCost = std::min(choice.nextCost, least[k]);
    }
    choice.nextCost = std::min(choice.nextCost, next[k]);
  }
  return choice;
}

} // namespace

/// A group's candidates in contiguous arrays.
struct LeafAuction::Candidates {
  static constexpr std::size_t kMost = kMostLeaves * kLeafSize;
  alignas(64) std::array<float, kMost> x;
  alignas(64) std::array<float, kMost> y;
  alignas(64) std::array<float, kMost> z;
  alignas(64) std::array<float, kMost> weight;
  std::size_t count = 0;

  Candidates(const LeafAuction& auction, const Group& group) {
    for (std::size_t l = 0; l < group.leafCount; ++l) {
      const std::size_t begin = group.leaves[l] * kLeafSize;
      const std::size_t length = std::min(kLeafSize, auction.sites_.size() - begin);
      std::fill_n(&x[count], kLeafSize, 0.0f);
      std::fill_n(&y[count], kLeafSize, 0.0f);
      std::fill_n(&z[count], kLeafSize, 0.0f);
      std::copy_n(&auction.sites_.x[begin], length, &x[count]);
      std::copy_n(&auction.sites_.y[begin], length, &y[count]);
      std::copy_n(&auction.sites_.z[begin], length, &z[count]);
      std::copy_n(&auction.weight_[begin], kLeafSize, &weight[count]);
      count += kLeafSize;
    }
    for (; count % kLanes != 0; ++count) {
      x[count] = y[count] = z[count] = 0.0f;
      weight[count] = kInfinite;
    }
  }

  [[nodiscard]] Choice chosenBy(const Point& p) const {
    return choose(x.data(), y.data(), z.data(), weight.data(), count,
                  {2.0f * p.x, 2.0f * p.y, 2.0f * p.z});
  }
};

LeafAuction::LeafAuction(const PointArrays& buyers, const PointArrays& sites,
                         std::span<const float> prices)
    : buyers_(buyers), sites_(sites),
      weight_((sites.size() + kLeafSize - 1) / kLeafSize * kLeafSize, kInfinite),
      siteOf_(buyers.size(), kNoPartner), buyerOf_(buyers.size(), kNoPartner),
      groups_((buyers.size() + kGroupSize - 1) / kGroupSize), waiting_(buyers.size()) {
  for (std::size_t j = 0; j < sites.size(); ++j)
    weight_[j] = dot(sites[j], sites[j]) + prices[j];
  for (std::size_t i = 0; i < buyers.size(); ++i)
    groups_[i / kGroupSize].waiting |= 1u << (i % kGroupSize);
}

void LeafAuction::setCandidates(std::size_t group, std::span<const std::uint32_t> leaves) {
  Group& g = groups_[group];
  g.leafCount = std::uint32_t(std::min(leaves.size(), kMostLeaves));
  std::copy_n(leaves.begin(), g.leafCount, g.leaves);
}

void LeafAuction::run(float increment, int rounds) {
  for (int round = 0; round < rounds && waiting_ > 0; ++round)
    for (std::size_t group = 0; group < groups_.size() && waiting_ > 0; ++group)
      if (groups_[group].waiting != 0)
        visit(group, increment);
}

void LeafAuction::give(std::uint32_t buyer, std::uint32_t site) {
  const std::uint32_t before = buyerOf_[site];
  if (before != kNoPartner) {
    siteOf_[before] = kNoPartner;
    groups_[before / kGroupSize].waiting |= 1u << (before % kGroupSize);
    ++waiting_;
  }
  buyerOf_[site] = buyer;
  siteOf_[buyer] = site;
  groups_[buyer / kGroupSize].waiting &= ~(1u << (buyer % kGroupSize));
  --waiting_;
}

void LeafAuction::visit(std::size_t group, float increment) {
  Candidates candidates(*this, groups_[group]);
  std::array<std::uint32_t, Candidates::kMost> winner;
  winner.fill(kNoPartner);
  // Holds at most the whole group, so the ring buffer does not overflow.
  std::array<std::uint32_t, kGroupSize> queue;
  std::size_t head = 0, tail = 0;
  for (std::uint32_t bits = groups_[group].waiting; bits != 0; bits &= bits - 1)
    queue[tail++] = std::uint32_t(group * kGroupSize) + std::uint32_t(std::countr_zero(bits));
  for (std::size_t bids = tail * kBidsAVisit; bids > 0 && head < tail; --bids) {
    const std::uint32_t buyer = queue[head++ % kGroupSize];
    const Choice choice = candidates.chosenBy(buyers_[buyer]);
    const float margin = choice.nextCost < kInfinite ? choice.nextCost - choice.cost : 0.0f;
    candidates.weight[choice.place] += margin + increment;
    if (winner[choice.place] != kNoPartner)
      queue[tail++ % kGroupSize] = winner[choice.place];
    winner[choice.place] = buyer;
  }
  for (std::size_t place = 0; place < candidates.count; ++place)
    if (winner[place] != kNoPartner) {
      const auto site =
          std::uint32_t(groups_[group].leaves[place / kLeafSize] * kLeafSize + place % kLeafSize);
      weight_[site] = candidates.weight[place];
      give(winner[place], site);
    }
}

float LeafAuction::leastCost(std::size_t buyer) const {
  const Point x = buyers_[buyer];
  const Candidates candidates(*this, groups_[buyer / kGroupSize]);
  return candidates.chosenBy(x).cost + dot(x, x);
}

} // namespace lichen::transport
