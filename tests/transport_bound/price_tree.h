// SPDX-License-Identifier: MIT
// The cheapest site for a buyer: a k-d tree over points that each carry a price.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <transport/point.h>
#include <vector>

namespace lichen::test {

/// The cheapest sites for one buyer, cheapest first, and a cost below which no other site is. The
/// list stays valid while prices only rise. With fewer than kCapacity sites it holds all of them.
struct Shortlist {
  /// Tuned on 256 x 256 photographs: 8 searches more often and 32 scans longer; both are slower.
  static constexpr std::size_t kCapacity = 16;
  std::array<std::uint32_t, kCapacity> places{};
  std::size_t count = 0;
  double othersCost = 0.0;
};

/// Finds the sites j with the least |x - y_j|^2 + price_j exactly, in double precision, while
/// prices change. A site's index is its position in the tree, so neighbours are close in memory.
class PriceTree {
public:
  /// Takes at least one finite site, and one price per site. Fast while prices stay near these.
  PriceTree(std::span<const Point> sites, std::span<const double> prices);

  /// About O(log N). Thread-safe while no price changes. A lower `limit` makes the search faster;
  /// it is a cost that at least Shortlist::kCapacity sites, or all sites, are known not to exceed.
  [[nodiscard]] Shortlist cheapest(const Point& x,
                                   double limit = std::numeric_limits<double>::infinity()) const;
  [[nodiscard]] double cost(const Point& x, std::uint32_t place) const;
  [[nodiscard]] double price(std::uint32_t place) const { return sites_[place].price; }
  /// O(log N).
  void setPrice(std::uint32_t place, double price);
  /// The index of a site in the constructor's `sites`, from its position in the tree.
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
  /// Node k has the children 2 k and 2 k + 1; the root is 1; the last leafCount_ nodes are the
  /// leaves. Every site y under a node has a price of at least slope . y + residual + lowestRise.
  struct Node {
    std::array<float, 3> low;
    std::array<float, 3> high;
    Vector slope;
    double residual;   ///< from the first prices
    double lowestRise; ///< least rise above the first prices
  };
  struct Search;

  [[nodiscard]] std::size_t leafBegin(std::size_t leaf) const {
    return leaf * sites_.size() / leafCount_;
  }
  void order(std::span<const Point> points, std::size_t node, std::size_t firstLeaf,
             std::size_t lastLeaf);
  void fitPrices(Node& node, std::size_t firstPlace, std::size_t lastPlace) const;
  void visit(Search& search, std::size_t node) const;

  std::size_t leafCount_ = 1;
  std::vector<std::uint32_t> order_; ///< the site at each position in the tree
  std::vector<Site> sites_;          ///< by position in the tree, leaf after leaf
  std::vector<double> firstPrice_;   ///< by position in the tree
  std::vector<Node> nodes_;
};

} // namespace lichen::test
