// SPDX-License-Identifier: MIT
// Prices from a matching: N pairs -> N prices, by sparse least squares.
#include "matching_prices.h"

#include "price_tree.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace lichen::test {
namespace {

using transport::PointPair;

/// Neighbours per target. Sixteen bring the dual value of the prices a tenth closer, for twice the
/// memory.
constexpr std::size_t kNeighbours = 8;

/// Solver tolerance. The errors left are within neighbourhoods, which the auction repairs; a
/// tolerance 100 times smaller does not make the auction faster. Price errors over long distances
/// have converged by then.
constexpr double kTolerance = 1e-2;
constexpr int kMostIterations = 500;

/// In units of the mean squared distance between neighbours: limits the weight of coincident
/// targets.
constexpr double kLeastDistance = 1e-3;

struct Edge {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  double squaredLength = 0.0;
};

/// From each target to its kNeighbours nearest.
std::vector<Edge> edgesBetween(std::span<const Point> targets) {
  const PriceTree tree(targets, std::vector<double>(targets.size(), 0.0));
  std::vector<Shortlist> nearest(targets.size());
  tbb::parallel_for(std::size_t(0), targets.size(),
                    [&](std::size_t i) { nearest[i] = tree.cheapest(targets[i]); });
  std::vector<Edge> edges;
  for (std::uint32_t i = 0; i < targets.size(); ++i) {
    std::size_t missing = kNeighbours;
    for (std::size_t k = 0; k < nearest[i].count && missing > 0; ++k) {
      const std::uint32_t place = nearest[i].places[k];
      if (tree.siteAt(place) == i)
        continue;
      edges.push_back({i, tree.siteAt(place), tree.cost(targets[i], place)});
      --missing;
    }
  }
  return edges;
}

/// price(b) - price(a), by the trapezoidal rule on grad price(y) = 2 (x - y).
double priceDifference(const PointPair& pairs, std::size_t a, std::size_t b) {
  const Point& xa = pairs.source[a];
  const Point& xb = pairs.source[b];
  const Point& ya = pairs.target[a];
  const Point& yb = pairs.target[b];
  const auto along = [](double x0, double x1, double y0, double y1) {
    return (x0 - y0 + x1 - y1) * (y1 - y0);
  };
  return along(xa.x, xb.x, ya.x, yb.x) + along(xa.y, xb.y, ya.y, yb.y) +
         along(xa.z, xb.z, ya.z, yb.z);
}

} // namespace

std::vector<double> pricesOfMatching(const PointPair& pairs) {
  const auto count = Eigen::Index(pairs.target.size());
  const std::vector<Edge> edges = edgesBetween(pairs.target);
  std::vector<double> prices(pairs.target.size(), 0.0);
  double meanSquare = 0.0;
  for (const Edge& edge : edges)
    meanSquare += edge.squaredLength / double(edges.size());
  if (!(meanSquare > 0.0))
    return prices;

  // A graph Laplacian; the weight of each edge is the inverse of its squared length.
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
  for (const Edge& edge : edges) {
    const int a = int(edge.from), b = int(edge.to);
    const double weight = 1.0 / std::max(edge.squaredLength, kLeastDistance * meanSquare);
    const double difference = weight * priceDifference(pairs, edge.from, edge.to);
    entries.insert(entries.end(),
                   {{a, b, -weight}, {b, a, -weight}, {a, a, weight}, {b, b, weight}});
    right[a] -= difference;
    right[b] += difference;
  }
  Eigen::SparseMatrix<double> laplacian(count, count);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver;
  solver.setTolerance(kTolerance);
  solver.setMaxIterations(kMostIterations);
  const Eigen::VectorXd solution = solver.compute(laplacian).solve(right);
  // With clusters far apart, the Laplacian has more null directions than the constant, and rounding
  // may make the solution infinite.
  if (solution.allFinite())
    std::copy(solution.begin(), solution.end(), prices.begin());
  return prices;
}

} // namespace lichen::test
