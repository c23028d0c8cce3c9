// SPDX-License-Identifier: MIT
// Prices from a matching: N pairs -> N prices, by sparse least squares.
#include "matching_prices.h"

#include "price_tree.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace lichen::transport {
namespace {

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

struct Neighbour {
  std::uint32_t site = 0;
  double squaredDistance = 0.0;
};

/// Up to kNeighbours neighbours of each target. Missing ones are the target itself.
std::vector<std::array<Neighbour, kNeighbours>> neighbours(std::span<const Point> targets) {
  const PriceTree tree(targets, std::vector<double>(targets.size(), 0.0));
  std::vector<std::array<Neighbour, kNeighbours>> result(targets.size());
  tbb::parallel_for(std::size_t(0), targets.size(), [&](std::size_t i) {
    const Shortlist nearest = tree.cheapest(targets[i]);
    std::size_t count = 0;
    result[i].fill({std::uint32_t(i), 0.0});
    for (std::size_t k = 0; k < nearest.count && count < kNeighbours; ++k)
      if (tree.siteAt(nearest.places[k]) != i)
        result[i][count++] = {tree.siteAt(nearest.places[k]),
                              tree.cost(targets[i], nearest.places[k])};
  });
  return result;
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

using Neighbourhood = std::array<Neighbour, kNeighbours>;

/// Entries for each target with each neighbour, their mirror images, and the diagonal.
std::size_t laplacianEntries(std::size_t count) { return count * (2 * kNeighbours + 1); }

/// The prices whose differences between neighbours fit those of the matching best in least squares.
/// Index is wide enough to count the entries of the normal equations.
template <class Index>
Eigen::VectorXd leastSquares(const PointPair& pairs, const std::vector<Neighbourhood>& near,
                             double leastSquaredDistance) {
  // A graph Laplacian; the weight of each edge is the inverse of its squared length.
  const std::size_t count = near.size();
  std::vector<Eigen::Triplet<double, Index>> entries;
  entries.reserve(laplacianEntries(count));
  std::vector<double> diagonal(count, 0.0);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(Eigen::Index(count));
  for (std::size_t a = 0; a < count; ++a)
    for (const Neighbour& neighbour : near[a]) {
      const std::size_t b = neighbour.site;
      if (a == b)
        continue;
      const double weight = 1.0 / std::max(neighbour.squaredDistance, leastSquaredDistance);
      const double difference = weight * priceDifference(pairs, a, b);
      entries.emplace_back(Index(a), Index(b), -weight);
      entries.emplace_back(Index(b), Index(a), -weight);
      diagonal[a] += weight;
      diagonal[b] += weight;
      right[Eigen::Index(a)] -= difference;
      right[Eigen::Index(b)] += difference;
    }
  for (std::size_t a = 0; a < count; ++a)
    entries.emplace_back(Index(a), Index(a), diagonal[a]);
  using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, Index>;
  Matrix laplacian{Eigen::Index(count), Eigen::Index(count)};
  laplacian.setFromTriplets(entries.begin(), entries.end());
  entries = {};

  Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper> solver;
  solver.setTolerance(kTolerance);
  solver.setMaxIterations(kMostIterations);
  return solver.compute(laplacian).solve(right);
}

} // namespace

std::vector<double> pricesOfMatching(const PointPair& pairs) {
  const std::size_t count = pairs.target.size();
  const std::vector<Neighbourhood> near = neighbours(pairs.target);
  double meanSquare = 0.0;
  for (const Neighbourhood& list : near)
    for (const Neighbour& neighbour : list)
      meanSquare += neighbour.squaredDistance / double(count * kNeighbours);
  std::vector<double> prices(count, 0.0);
  if (!(meanSquare > 0.0))
    return prices;

  // Wide indices take 1.5 times the memory, and only images above 11,000 x 11,000 need them.
  const bool isNarrow = laplacianEntries(count) <= std::numeric_limits<std::int32_t>::max();
  const double leastSquaredDistance = kLeastDistance * meanSquare;
  const Eigen::VectorXd solution =
      isNarrow ? leastSquares<std::int32_t>(pairs, near, leastSquaredDistance)
               : leastSquares<std::int64_t>(pairs, near, leastSquaredDistance);
  // With clusters far apart, the Laplacian has more null directions than the constant, and rounding
  // may make the solution infinite.
  if (solution.allFinite())
    std::copy(solution.begin(), solution.end(), prices.begin());
  return prices;
}

} // namespace lichen::transport
