// SPDX-License-Identifier: MIT
// The cheapest site for a buyer: a k-d tree over points that each carry a price.
#pragma once

#include "point.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace lichen::transport {

/// The sites that are cheapest for one buyer, cheapest first, and a cost that no other site is
/// below; that stays so while prices only rise. With fewer than kCapacity sites all of them are
/// listed.
struct Shortlist {
  /// Tuned on photographs of 256 x 256: 8 searches more often, 32 scans longer, both slower.
  static constexpr std::size_t kCapacity = 16;
  std::array<std::uint32_t, kCapacity> places{};
  std::size_t count = 0;
  double othersCost = 0.0;
};

/// Finds the sites j with the least |x - y_j|^2 + price_j exactly, in double precision, while
/// prices change. A site is known by its place in the tree, so that neighbours lie together in
/// memory.
class PriceTree {
public:
  /// At least one site, finite, and a price for each. Fast while prices stay near those given.
  PriceTree(std::span<const Point> sites, std::span<const double> prices);

  /// About O(log N). Thread-safe while no price changes. A search is the faster the lower `limit`:
  /// a cost that at least Shortlist::kCapacity sites are known not to exceed, or all there are.
  [[nodiscard]] Shortlist cheapest(const Point& x,
                                   double limit = std::numeric_limits<double>::infinity()) const;
  [[nodiscard]] double leastCost(const Point& x) const;

  [[nodiscard]] double cost(const Point& x, std::uint32_t place) const;
  [[nodiscard]] double price(std::uint32_t place) const { return sites_[place].price; }
  /// O(log N).
  void setPrice(std::uint32_t place, double price);
  /// The index, among the sites given, of the one at a place.
  [[nodiscard]] std::uint32_t siteAt(std::uint32_t place) const { return order_[place]; }

private:
  using Vector = std::array<double, 3>;

  struct Site {
    Vector position;
    double price;

    [[nodiscard]] double costFor(const Vector& at) const {
      const double dx = at[0] - position[0];
      const double dy = at[1] - position[1];
      const double dz = at[2] - position[2];
      return dx * dx + dy * dy + dz * dz + price;
    }
  };
  /// Node k has the children 2 k and 2 k + 1; the root is 1; the leaves are the last leafCount_.
  /// Every site under it has a price of at least slope . y + residual + lowestRise.
  struct Node {
    std::array<float, 3> low;
    std::array<float, 3> high;
    Vector slope;
    double residual;   ///< of the first prices
    double lowestRise; ///< above the first prices
  };
  template <std::size_t kWanted>
  struct Search;

  [[nodiscard]] std::size_t leafBegin(std::size_t leaf) const {
    return leaf * sites_.size() / leafCount_;
  }
  void order(std::span<const Point> points, std::size_t node, std::size_t firstLeaf,
             std::size_t lastLeaf);
  void fitPrices(Node& node, std::size_t firstPlace, std::size_t lastPlace) const;
  template <std::size_t kWanted>
  void visit(Search<kWanted>& search, std::size_t node) const;

  std::size_t leafCount_ = 1;
  std::vector<std::uint32_t> order_; ///< the site at each place
  std::vector<Site> sites_;          ///< by place: leaf after leaf
  std::vector<double> firstPrice_;   ///< by place
  std::vector<Node> nodes_;
};

} // namespace lichen::transport
