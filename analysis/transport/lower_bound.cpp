// SPDX-License-Identifier: MIT
// Lower bound of the transport cost: N points, N points and a matching -> a bound, and the
// auction's own matching.
#include "lower_bound.h"

#include "auction.h"
#include "matching_prices.h"
#include "precondition.h"
#include "price_tree.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <vector>

namespace lichen::transport {
namespace {

/// Ratio between the steps of successive auctions (epsilon scaling).
constexpr double kStepRatio = 4.0;
/// The first auction's step covers the duality gap per pair in at most this many steps. Larger
/// steps spoil prices that are nearly right; smaller steps take long to repair prices that are not.
constexpr double kStepsOfGap = 8.0;

/// precondition() rounds coordinates to float, 2^-24 on each side of a product. It also drops
/// directions whose standard deviations multiply to at most 1e-6 of the largest, at most two
/// directions at each of its three thresholds.
constexpr double kRounding = 0x1.0p-23;
constexpr double kLeftOut = 6e-6;

/// In the auction's matching all but a few pairs are within a step; these rounds exchange the rest.
/// On the exemplars of lichen-bench, more rounds gain less than 0.001 %.
const TransportOptions kMending{.swapRounds = 4, .exactRounds = 8};
/// Share of improveByAuction()'s progress. On 256 x 256 photographs the auctions take 3 s to 30 s,
/// the rest 0.5 s.
constexpr double kAuctionOfProgress = 0.9;

/// min_j |x_i - y_j|^2 + price_j for every i.
std::vector<double> leastCosts(std::span<const Point> buyers, const PriceTree& sites) {
  std::vector<double> costs(buyers.size());
  tbb::parallel_for(std::size_t(0), buyers.size(),
                    [&](std::size_t i) { costs[i] = sites.leastCost(buyers[i]); });
  return costs;
}

/// A lower bound on the cost of every bijection (linear programming duality).
double dualValue(std::span<const Point> buyers, std::span<const Point> targets,
                 std::span<const double> prices) {
  const std::vector<double> costs = leastCosts(buyers, PriceTree(targets, prices));
  return std::accumulate(costs.begin(), costs.end(), 0.0) -
         std::accumulate(prices.begin(), prices.end(), 0.0);
}

double pairsCost(const PointPair& pairs) {
  std::vector<std::uint32_t> itself(pairs.source.size());
  std::iota(itself.begin(), itself.end(), 0u);
  return transportCost(pairs.source, pairs.target, itself) * double(pairs.source.size());
}

struct DualSolution {
  double value = 0.0; ///< of the preconditioned problem
  std::vector<std::optional<std::uint32_t>> targetOf;
};

/// Raises the prices of the pairs' own matching by auctions with decreasing steps, down to
/// `increment`.
DualSolution solveDual(const PointPair& pairs, double increment, const ProgressPart& progress) {
  std::vector<double> prices = pricesOfMatching(pairs);
  const double gap = pairsCost(pairs) - dualValue(pairs.source, pairs.target, prices);
  double step = increment;
  int auctions = 1;
  for (; step * kStepsOfGap * double(pairs.source.size()) < gap; ++auctions)
    step *= kStepRatio;
  DualSolution solution;
  for (int k = 0; k < auctions; ++k, step /= kStepRatio) {
    PriceTree sites(pairs.target, prices);
    solution.targetOf = runAuction(pairs.source, sites, step,
                                   progress.part(double(k) / auctions, double(k + 1) / auctions));
    for (std::uint32_t place = 0; place < prices.size(); ++place)
      prices[sites.siteAt(place)] = sites.price(place);
  }
  solution.value = dualValue(pairs.source, pairs.target, prices);
  return solution;
}

/// Gives the targets without a source, in order, to the sources without a target.
std::vector<std::uint32_t> completed(const std::vector<std::optional<std::uint32_t>>& targetOf) {
  std::vector<bool> taken(targetOf.size(), false);
  for (const std::optional<std::uint32_t>& target : targetOf)
    if (target)
      taken[*target] = true;
  std::vector<std::uint32_t> complete;
  std::uint32_t next = 0;
  for (const std::optional<std::uint32_t>& target : targetOf) {
    while (!target && taken[next])
      ++next;
    complete.push_back(target ? *target : next++);
  }
  return complete;
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

/// The squared distance between two means.
double squaredDistance(const Moments& a, const Moments& b) {
  const double x = a.meanX - b.meanX, y = a.meanY - b.meanY, z = a.meanZ - b.meanZ;
  return x * x + y * y + z * z;
}

double sumOfSquares(std::span<const Point> points) {
  double sum = 0.0;
  for (const Point& p : points)
    sum += double(p.x) * double(p.x) + double(p.y) * double(p.y) + double(p.z) * double(p.z);
  return sum;
}

/// The bound of a matching, and the target that the auction gave to each source.
struct BoundAndAuction {
  TransportBound bound;
  std::vector<std::optional<std::uint32_t>> targetOf;
};

BoundAndAuction boundByAuction(std::span<const Point> source, std::span<const Point> target,
                               std::span<const std::uint32_t> assignment, double tolerance,
                               const ProgressPart& progress) {
  assert(source.size() == target.size() && source.size() == assignment.size());
  assert(tolerance >= 1e-6 && tolerance <= 1.0);
  BoundAndAuction result;
  TransportBound& bound = result.bound;
  if (source.empty())
    return result;
  const double count = double(source.size());
  const Moments from = momentsOf(source);
  const Moments to = momentsOf(target);
  const double meansApart = squaredDistance(from, to);
  bound.cost = transportCost(source, target, assignment);
  bound.centredCost = std::max(0.0, bound.cost - meansApart);
  bound.lowerBound = meansApart;
  if (!(bound.centredCost > 0.0))
    return result;

  // sum |x - y|^2 = sum |x|^2 + sum |y|^2 - 2 sum <x, y>, about the means, and <x, y> = <x', y'>.
  PointPair pairs = precondition(source, target);
  const std::vector<Point> targets = std::move(pairs.target);
  pairs.target.clear();
  for (const std::uint32_t j : assignment)
    pairs.target.push_back(targets[j]);
  DualSolution solution = solveDual(pairs, tolerance * bound.centredCost, progress);
  const double squares = sumOfSquares(pairs.source) + sumOfSquares(pairs.target);
  const double largestProduct = 0.5 * (squares - solution.value);
  // By Cauchy-Schwarz, this bounds the sum of the errors of all products of a bijection.
  const double slack = (kRounding + kLeftOut) * std::sqrt(from.squares * to.squares);
  const double centred = from.squares + to.squares - 2.0 * (largestProduct + slack);
  bound.lowerBound = meansApart + std::max(0.0, centred / count);
  result.targetOf = std::move(solution.targetOf);
  return result;
}

} // namespace

TransportBound boundTransportCost(std::span<const Point> source, std::span<const Point> target,
                                  std::span<const std::uint32_t> assignment, double tolerance,
                                  ProgressPart progress) {
  return boundByAuction(source, target, assignment, tolerance, progress).bound;
}

TransportBound improveByAuction(std::span<const Point> source, std::span<const Point> target,
                                std::vector<std::uint32_t>& assignment, double tolerance,
                                ProgressPart progress) {
  BoundAndAuction found =
      boundByAuction(source, target, assignment, tolerance, progress.part(0.0, kAuctionOfProgress));
  if (found.targetOf.empty())
    return found.bound;
  std::vector<std::uint32_t> better = completed(found.targetOf);
  for (std::uint32_t& pair : better)
    pair = assignment[pair];
  TransportOptions mending = kMending;
  mending.progress = progress.part(kAuctionOfProgress, 1.0);
  better = improveAssignment(source, target, std::move(better), mending);
  const double cost = transportCost(source, target, better);
  if (cost < found.bound.cost) {
    found.bound.centredCost -= found.bound.cost - cost;
    found.bound.cost = cost;
    assignment = std::move(better);
  }
  return found.bound;
}

TransportBound boundOfOptimum(std::span<const Point> source, std::span<const Point> target,
                              std::span<const std::uint32_t> assignment) {
  const double cost = transportCost(source, target, assignment);
  const double meansApart =
      source.empty() ? 0.0 : squaredDistance(momentsOf(source), momentsOf(target));
  return {cost, cost, std::max(0.0, cost - meansApart)};
}

} // namespace lichen::transport
