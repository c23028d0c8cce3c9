// SPDX-License-Identifier: MIT
// Lower bound of the transport cost: N points, N points and a matching -> a bound, and the
// auction's own matching.
#include "lower_bound.h"

#include "auction.h"
#include "matching_prices.h"
#include "price_tree.h"

#include <Eigen/Dense>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <optional>
#include <transport/assignment.h>
#include <transport/covariance.h>
#include <transport/precondition.h>

namespace lichen::test {
namespace {

using Eigen::Vector3d;
using transport::PointPair;

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

Vector3d vectorOf(const Point& p) { return {p.x, p.y, p.z}; }

/// A lower bound on the cost of every bijection (linear programming duality).
double dualValue(const PointPair& pairs, const std::vector<double>& prices) {
  const PriceTree sites(pairs.target, prices);
  std::vector<double> costs(pairs.source.size());
  tbb::parallel_for(std::size_t(0), costs.size(), [&](std::size_t i) {
    const Point& x = pairs.source[i];
    costs[i] = sites.cost(x, sites.cheapest(x).places[0]);
  });
  return std::accumulate(costs.begin(), costs.end(), 0.0) -
         std::accumulate(prices.begin(), prices.end(), 0.0);
}

double pairsCost(const PointPair& pairs) {
  double sum = 0.0;
  for (std::size_t i = 0; i < pairs.source.size(); ++i)
    sum += (vectorOf(pairs.source[i]) - vectorOf(pairs.target[i])).squaredNorm();
  return sum;
}

struct DualSolution {
  double value = 0.0; ///< of the preconditioned problem
  std::vector<std::optional<std::uint32_t>> targetOf;
};

/// Raises the prices of the pairs' own matching by auctions with decreasing steps, down to
/// `increment`.
DualSolution solveDual(const PointPair& pairs, double increment) {
  std::vector<double> prices = pricesOfMatching(pairs);
  const double gap = pairsCost(pairs) - dualValue(pairs, prices);
  double step = increment;
  while (step * kStepsOfGap * double(pairs.source.size()) < gap)
    step *= kStepRatio;
  DualSolution solution;
  for (; step > increment / kStepRatio; step /= kStepRatio) {
    PriceTree sites(pairs.target, prices);
    solution.targetOf = runAuction(pairs.source, sites, step);
    for (std::uint32_t place = 0; place < prices.size(); ++place)
      prices[sites.siteAt(place)] = sites.price(place);
  }
  solution.value = dualValue(pairs, prices);
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

transport::Moments<Eigen::Matrix3d> momentsOf(std::span<const Point> points) {
  return transport::momentsOf<Eigen::Matrix3d>(
      points.size(), 3, [&](std::size_t i, int c) { return vectorOf(points[i])[c]; });
}

double sumOfSquares(std::span<const Point> points) {
  double sum = 0.0;
  for (const Point& p : points)
    sum += vectorOf(p).squaredNorm();
  return sum;
}

} // namespace

TransportBound boundTransportCost(std::span<const Point> source, std::span<const Point> target,
                                  std::span<const std::uint32_t> assignment, double tolerance) {
  assert(source.size() == target.size() && source.size() == assignment.size());
  assert(tolerance >= 1e-6 && tolerance <= 1.0);
  if (source.empty())
    return {};
  const auto from = momentsOf(source);
  const auto to = momentsOf(target);
  const double meansApart = (from.mean - to.mean).squaredNorm();
  TransportBound bound;
  bound.auctioned.assign(assignment.begin(), assignment.end());
  bound.cost = transport::transportCost(source, target, assignment);
  bound.centredCost = std::max(0.0, bound.cost - meansApart);
  bound.lowerBound = meansApart;
  if (!(bound.centredCost > 0.0))
    return bound;

  // sum |x - y|^2 = sum |x|^2 + sum |y|^2 - 2 sum <x, y>, about the means, and <x, y> = <x', y'>.
  PointPair pairs = transport::precondition(source, target);
  const std::vector<Point> targets = std::move(pairs.target);
  pairs.target.clear();
  for (const std::uint32_t j : assignment)
    pairs.target.push_back(targets[j]);
  const DualSolution solution = solveDual(pairs, tolerance * bound.centredCost);
  const double fromSquares = double(source.size()) * from.covariance.trace();
  const double toSquares = double(source.size()) * to.covariance.trace();
  const double squares = sumOfSquares(pairs.source) + sumOfSquares(pairs.target);
  const double largestProduct = 0.5 * (squares - solution.value);
  // By Cauchy-Schwarz, this bounds the sum of the errors of all products of a bijection.
  const double slack = (kRounding + kLeftOut) * std::sqrt(fromSquares * toSquares);
  const double centred = fromSquares + toSquares - 2.0 * (largestProduct + slack);
  bound.lowerBound = meansApart + std::max(0.0, centred / double(source.size()));
  bound.auctioned = completed(solution.targetOf);
  for (std::uint32_t& pair : bound.auctioned)
    pair = assignment[pair];
  return bound;
}

} // namespace lichen::test
