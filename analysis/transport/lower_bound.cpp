// SPDX-License-Identifier: MIT
// Lower bound of the transport cost; N points, N points and a matching -> a bound.
// Prices are found for a small random subset of the matched pairs and carried over to a larger one,
// up to all pairs: a step of the coarse auction crosses what would take the fine one many.
#include "lower_bound.h"

#include "assignment.h"
#include "auction.h"
#include "precondition.h"
#include "price_tree.h"
#include "random.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <vector>

namespace lichen::transport {
namespace {

/// Pairs in a subset over pairs in the next smaller: distances between neighbours double.
constexpr std::size_t kRefinement = 8;
/// Steps of prices go with squared distances.
constexpr double kStepRatio = 4.0;
constexpr std::size_t kSmallestSubset = 128;
/// Auctions begin with steps that cover the duality gap in this many: larger ones spoil prices that
/// are nearly right, smaller ones take long to mend prices that are not [epsilon scaling].
constexpr double kStepsOfGap = 8.0;

/// precondition() rounds coordinates to float, 2^-24 on each side of a product; and leaves out
/// directions whose deviations multiply to at most 1e-6 of the largest, in at most two directions
/// on each of its three floors.
constexpr double kRounding = 0x1.0p-23;
constexpr double kLeftOut = 6e-6;

constexpr std::uint64_t kSubsetStream = 0x626f756e64u;

/// The pairs of `assignment`, in a random order, so that the first n are a fair sample.
PointPair shuffledPairs(const PointPair& points, std::span<const std::uint32_t> assignment) {
  std::vector<std::uint32_t> order(assignment.size());
  std::iota(order.begin(), order.end(), 0u);
  for (std::size_t i = order.size(); i-- > 1;)
    std::swap(order[i], order[randomBits(kSubsetStream, i) % (i + 1)]);
  PointPair pairs;
  for (const std::uint32_t i : order) {
    pairs.source.push_back(points.source[i]);
    pairs.target.push_back(points.target[assignment[i]]);
  }
  return pairs;
}

/// min_j |x_i - y_j|^2 + price_j for every i.
std::vector<double> leastCosts(std::span<const Point> buyers, const PriceTree& sites) {
  std::vector<double> costs(buyers.size());
  tbb::parallel_for(std::size_t(0), buyers.size(),
                    [&](std::size_t i) { costs[i] = sites.leastCost(buyers[i]); });
  return costs;
}

/// The lowest prices at all `sites` that leave the buyers of a coarser problem their least costs:
/// price(y) = max_i (least cost of i - |x_i - y|^2), a c-transform.
std::vector<double> carriedOver(std::span<const Point> buyers, std::vector<double> buyersCosts,
                                std::span<const Point> sites) {
  for (double& cost : buyersCosts)
    cost = -cost;
  std::vector<double> prices = leastCosts(sites, PriceTree(buyers, buyersCosts));
  for (double& price : prices)
    price = -price;
  return prices;
}

std::vector<double> pricesAfterAuction(std::span<const Point> buyers,
                                       std::span<const Point> targets,
                                       std::span<const double> prices, double increment,
                                       const ProgressPart& progress) {
  PriceTree sites(targets, prices);
  runAuction(buyers, sites, increment, progress);
  std::vector<double> raised(targets.size());
  for (std::uint32_t place = 0; place < targets.size(); ++place)
    raised[sites.siteAt(place)] = sites.price(place);
  return raised;
}

/// At most the cost of every bijection [linear programming duality].
double dualValue(std::span<const Point> buyers, std::span<const Point> targets,
                 std::span<const double> prices) {
  const std::vector<double> costs = leastCosts(buyers, PriceTree(targets, prices));
  return std::accumulate(costs.begin(), costs.end(), 0.0) -
         std::accumulate(prices.begin(), prices.end(), 0.0);
}

double pairsCost(std::span<const Point> buyers, std::span<const Point> targets) {
  std::vector<std::uint32_t> itself(buyers.size());
  std::iota(itself.begin(), itself.end(), 0u);
  return transportCost(buyers, targets, itself) * double(buyers.size());
}

/// The best dual value found for the preconditioned problem.
double bestDualValue(const PointPair& pairs, double increment, const ProgressPart& progress) {
  std::vector<std::size_t> sizes{pairs.source.size()};
  while (sizes.back() > kSmallestSubset)
    sizes.push_back(sizes.back() / kRefinement);
  const auto pairCount = double(std::accumulate(sizes.begin(), sizes.end(), std::size_t(0)));
  double done = 0.0;
  std::vector<double> prices(sizes.back(), 0.0);
  for (std::size_t level = sizes.size();; --level) {
    const std::span<const Point> buyers(pairs.source.data(), sizes[level - 1]);
    const std::span<const Point> targets(pairs.target.data(), sizes[level - 1]);
    const double last = increment * std::pow(kStepRatio, double(level - 1));
    const double gap = pairsCost(buyers, targets) - dualValue(buyers, targets, prices);
    double step = last;
    int auctions = 1;
    for (; step * kStepsOfGap * double(buyers.size()) < gap; ++auctions)
      step *= kStepRatio;
    const double share = double(buyers.size()) / pairCount / auctions;
    for (; auctions > 0; --auctions, step /= kStepRatio, done += share)
      prices = pricesAfterAuction(buyers, targets, prices, step,
                                  progress.part(done, std::min(1.0, done + share)));
    if (level == 1)
      return dualValue(buyers, targets, prices);
    prices = carriedOver(buyers, leastCosts(buyers, PriceTree(targets, prices)),
                         {pairs.target.data(), sizes[level - 2]});
  }
}

struct Moments {
  double meanX = 0.0, meanY = 0.0, meanZ = 0.0;
  double squares = 0.0; ///< sum of squared distances from the mean
};

Moments momentsOf(std::span<const Point> points) {
  Moments m;
  const double count = double(points.size());
  for (const Point& p : points) {
    m.meanX += double(p.x) / count;
    m.meanY += double(p.y) / count;
    m.meanZ += double(p.z) / count;
  }
  for (const Point& p : points) {
    const double x = double(p.x) - m.meanX;
    const double y = double(p.y) - m.meanY;
    const double z = double(p.z) - m.meanZ;
    m.squares += x * x + y * y + z * z;
  }
  return m;
}

double sumOfSquares(std::span<const Point> points) {
  double sum = 0.0;
  for (const Point& p : points)
    sum += double(p.x) * double(p.x) + double(p.y) * double(p.y) + double(p.z) * double(p.z);
  return sum;
}

} // namespace

TransportBound boundTransportCost(std::span<const Point> source, std::span<const Point> target,
                                  std::span<const std::uint32_t> assignment, double tolerance,
                                  ProgressPart progress) {
  assert(source.size() == target.size() && source.size() == assignment.size());
  assert(tolerance >= 1e-6 && tolerance <= 1.0);
  TransportBound bound;
  if (source.empty())
    return bound;
  const double count = double(source.size());
  const Moments from = momentsOf(source);
  const Moments to = momentsOf(target);
  const double dx = from.meanX - to.meanX;
  const double dy = from.meanY - to.meanY;
  const double dz = from.meanZ - to.meanZ;
  const double meansApart = dx * dx + dy * dy + dz * dz;
  bound.cost = transportCost(source, target, assignment);
  bound.centredCost = std::max(0.0, bound.cost - meansApart);
  bound.lowerBound = meansApart;
  if (!(bound.centredCost > 0.0))
    return bound;

  // sum |x - y|^2 = sum |x|^2 + sum |y|^2 - 2 sum <x, y>, about the means; <x, y> = <x', y'>.
  const PointPair points = precondition(source, target);
  const double dual =
      bestDualValue(shuffledPairs(points, assignment), tolerance * bound.centredCost, progress);
  const double squares = sumOfSquares(points.source) + sumOfSquares(points.target);
  const double largestProduct = 0.5 * (squares - dual);
  // By Cauchy and Schwarz the errors of all products of a bijection sum up to no more than this.
  const double slack = (kRounding + kLeftOut) * std::sqrt(from.squares * to.squares);
  const double centred = from.squares + to.squares - 2.0 * (largestProduct + slack);
  bound.lowerBound = meansApart + std::max(0.0, centred / count);
  return bound;
}

} // namespace lichen::transport
