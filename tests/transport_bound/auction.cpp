// SPDX-License-Identifier: MIT
// Forward auction, one bid at a time: N buyers and N sites -> prices, and a site for most buyers.
#include "auction.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

namespace lichen::test {
namespace {

/// The share of buyers left without a site. The last buyers move from site to site for as long as
/// all the others took, and their prices hardly change the dual value. Even if each were ten steps
/// from its price, the bound would lose 0.02 of a step, against the half step that it loses anyway.
constexpr double kLeftOver = 0.002;

/// Average bids per buyer at which the auction stops; photographs take 10 to 30. Any prices give a
/// bound.
constexpr std::size_t kMostBids = 200;

struct Choice {
  std::uint32_t place = 0;
  double cost = std::numeric_limits<double>::infinity();
  double nextCost = std::numeric_limits<double>::infinity();
  double highestCost = -std::numeric_limits<double>::infinity(); ///< on the shortlist
};

Choice choose(const Point& buyer, const PriceTree& sites, const Shortlist& list) {
  Choice choice;
  for (std::size_t k = 0; k < list.count; ++k) {
    const double cost = sites.cost(buyer, list.places[k]);
    choice.highestCost = std::max(choice.highestCost, cost);
    if (cost < choice.cost) {
      choice.nextCost = choice.cost;
      choice.cost = cost;
      choice.place = list.places[k];
    } else if (cost < choice.nextCost) {
      choice.nextCost = cost;
    }
  }
  return choice;
}

} // namespace

std::vector<std::optional<std::uint32_t>> runAuction(std::span<const Point> buyers,
                                                     PriceTree& sites, double increment) {
  std::vector<std::optional<std::uint32_t>> siteOf(buyers.size());
  if (buyers.size() < 2)
    return siteOf;
  std::vector<Shortlist> lists(buyers.size());
  tbb::parallel_for(std::size_t(0), buyers.size(),
                    [&](std::size_t i) { lists[i] = sites.cheapest(buyers[i]); });
  std::vector<std::optional<std::uint32_t>> owner(buyers.size());
  std::deque<std::uint32_t> waiting(buyers.size());
  std::iota(waiting.begin(), waiting.end(), 0u);
  const auto leftOver = std::size_t(kLeftOver * double(buyers.size()));
  for (std::size_t bid = 0; waiting.size() > leftOver && bid < kMostBids * buyers.size(); ++bid) {
    const std::uint32_t buyer = waiting.front();
    waiting.pop_front();
    Choice choice = choose(buyers[buyer], sites, lists[buyer]);
    if (choice.nextCost > lists[buyer].othersCost) {
      lists[buyer] = sites.cheapest(buyers[buyer], choice.highestCost);
      choice = choose(buyers[buyer], sites, lists[buyer]);
    }
    sites.setPrice(choice.place,
                   sites.price(choice.place) + (choice.nextCost - choice.cost) + increment);
    if (owner[choice.place])
      waiting.push_back(*owner[choice.place]);
    owner[choice.place] = buyer;
  }
  for (std::uint32_t place = 0; place < owner.size(); ++place)
    if (owner[place])
      siteOf[*owner[place]] = sites.siteAt(place);
  return siteOf;
}

} // namespace lichen::test
