// SPDX-License-Identifier: MIT
// Multiscale matching: N points and N points -> a permutation.
#include "multiscale.h"

#include "leaf_auction.h"
#include "partition_tree.h"

#include <nanoflann.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <limits>
#include <span>

namespace lichen::transport {
namespace {

constexpr std::size_t kCell = LeafAuction::kLeafSize;

/// The most centroids at the coarsest level, where every leaf is a candidate.
constexpr std::size_t kCoarsest = LeafAuction::kMostLeaves * kCell;

/// Neighbours of a cell that supply prices and candidates: as many as touch one sphere in a closest
/// packing.
constexpr std::size_t kNeighbours = 12;

/// The auction's increment in units of the mean squared distance of a cell's targets from their
/// centroid, which is about the squared distance of neighbours. On the exemplars of lichen-bench,
/// half of it gains nothing, and twice of it makes the excess over the optimum 1.5 times as large.
constexpr float kIncrement = 1.0f;
/// The coarsest level has no prices to start from, so its increments decrease in these steps.
constexpr std::array<float, 4> kCoarsestSteps{64.0f, 16.0f, 4.0f, 1.0f};

/// Rounds of bids. The prices of cells determine the finer levels, so their auctions last until
/// nearly all have a site. Points that are left after a few rounds are cheaper to match among
/// themselves.
constexpr int kRoundsOfCells = 100;
constexpr int kRoundsOfPoints = 12;

/// One level of the hierarchy: the points, or the centroids of the next finer level's cells.
struct Level {
  PointArrays source;
  PointArrays target;

  [[nodiscard]] std::size_t size() const { return source.size(); }
};

/// The matching of a level, and the dual variables of its sources.
struct Solution {
  std::vector<std::uint32_t> targetOf;
  std::vector<float> sourceCost; ///< min_j |x_i - y_j|^2 + price_j
};

PointArrays reordered(std::span<const Point> points, std::span<const std::uint32_t> order) {
  PointArrays result;
  for (const std::uint32_t i : order)
    result.push_back(points[i]);
  return result;
}

PointArrays centroids(const PointArrays& points) {
  PointArrays result;
  for (std::size_t begin = 0; begin < points.size(); begin += kCell) {
    const std::size_t end = std::min(points.size(), begin + kCell);
    Point sum;
    for (std::size_t i = begin; i < end; ++i)
      sum = {sum.x + points.x[i], sum.y + points.y[i], sum.z + points.z[i]};
    const float share = 1.0f / float(end - begin);
    result.push_back({sum.x * share, sum.y * share, sum.z * share});
  }
  return result;
}

/// Mean squared distance of targets from their cell's centroid.
float spreadOfCells(const PointArrays& targets) {
  const PointArrays middles = centroids(targets);
  double sum = 0.0;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const Point t = targets[i];
    const Point m = middles[i / kCell];
    const Point d{t.x - m.x, t.y - m.y, t.z - m.z};
    sum += double(dot(d, d));
  }
  return float(sum / double(targets.size()));
}

/// Points as nanoflann reads them.
struct Cloud {
  const PointArrays& points;

  [[nodiscard]] std::size_t kdtree_get_point_count() const { return points.size(); }
  [[nodiscard]] float kdtree_get_pt(std::size_t i, std::size_t axis) const {
    return (axis == 0 ? points.x : axis == 1 ? points.y : points.z)[i];
  }
  [[nodiscard]] bool kdtree_get_bbox(auto&) const { return false; } // let the tree compute it
};
using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Cloud>, Cloud,
                                                 3, std::uint32_t>;

/// The kNeighbours nearest points of each point, including itself; all points if there are fewer.
class Neighbours {
public:
  explicit Neighbours(const PointArrays& points)
      : count_(std::min(kNeighbours, points.size())), indices_(points.size() * count_) {
    const Cloud cloud{points};
    const Tree tree(3, cloud);
    tbb::parallel_for(std::size_t(0), points.size(), [&](std::size_t i) {
      const std::array<float, 3> at{points.x[i], points.y[i], points.z[i]};
      std::array<float, kNeighbours> squaredDistances;
      tree.knnSearch(at.data(), count_, &indices_[i * count_], squaredDistances.data());
    });
  }

  [[nodiscard]] std::span<const std::uint32_t> of(std::size_t i) const {
    return {&indices_[i * count_], count_};
  }

private:
  std::size_t count_;
  std::vector<std::uint32_t> indices_;
};

/// Prices of the finer level's targets, by the c-transform of the cells' dual variables:
/// max_i (cost of i - |x_i - y|^2) over the sources i matched to the cells around y.
std::vector<float> carriedOver(const Level& cells, const Solution& coarse,
                               const Neighbours& neighbours, const PointArrays& targets) {
  std::vector<std::uint32_t> sourceOf(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
    sourceOf[coarse.targetOf[i]] = std::uint32_t(i);
  std::vector<float> prices(targets.size(), -std::numeric_limits<float>::infinity());
  tbb::parallel_for(std::size_t(0), cells.size(), [&](std::size_t cell) {
    const std::size_t end = std::min(targets.size(), (cell + 1) * kCell);
    for (std::size_t j = cell * kCell; j < end; ++j)
      for (const std::uint32_t neighbour : neighbours.of(cell)) {
        const std::uint32_t i = sourceOf[neighbour];
        const Point x = cells.source[i];
        const Point y = targets[j];
        const Point d{x.x - y.x, x.y - y.y, x.z - y.z};
        prices[j] = std::max(prices[j], coarse.sourceCost[i] - dot(d, d));
      }
  });
  return prices;
}

/// Sets a group's candidates: the cells matched to its cells, then their neighbours, nearest first.
void setCandidates(LeafAuction& auction, std::size_t group, const Solution& coarse,
                   const Neighbours& neighbours) {
  constexpr std::size_t kCellsOfGroup = LeafAuction::kGroupSize / kCell;
  std::vector<std::uint32_t> leaves;
  const std::size_t begin = group * kCellsOfGroup;
  const std::size_t end = std::min(coarse.targetOf.size(), begin + kCellsOfGroup);
  for (std::size_t rank = 0; rank < neighbours.of(0).size(); ++rank)
    for (std::size_t cell = begin; cell < end; ++cell) {
      const std::uint32_t leaf = neighbours.of(coarse.targetOf[cell])[rank];
      if (std::find(leaves.begin(), leaves.end(), leaf) == leaves.end())
        leaves.push_back(leaf);
    }
  auction.setCandidates(group, leaves);
}

/// Matches the points that an auction left over by a partition of their own.
std::vector<std::uint32_t> completed(const LeafAuction& auction, const Level& level) {
  std::vector<std::uint32_t> targetOf = auction.siteOf();
  std::vector<std::uint32_t> sources, targets;
  std::vector<Point> sourcePoints, targetPoints;
  for (std::uint32_t k = 0; k < targetOf.size(); ++k) {
    if (targetOf[k] == kNoPartner) {
      sources.push_back(k);
      sourcePoints.push_back(level.source[k]);
    }
    if (auction.buyerOf()[k] == kNoPartner) {
      targets.push_back(k);
      targetPoints.push_back(level.target[k]);
    }
  }
  const PartitionOrder order = partitionOrder(sourcePoints, targetPoints, 1);
  for (std::size_t k = 0; k < sources.size(); ++k)
    targetOf[sources[order.source[k]]] = targets[order.target[k]];
  return targetOf;
}

Solution solveCoarsest(const Level& level) {
  std::vector<std::uint32_t> leaves;
  for (std::uint32_t leaf = 0; leaf * kCell < level.size(); ++leaf)
    leaves.push_back(leaf);
  const float spread = spreadOfCells(level.target);
  std::vector<float> prices(level.size(), 0.0f);
  Solution solution;
  for (const float step : kCoarsestSteps) {
    LeafAuction auction(level.source, level.target, prices);
    for (std::size_t group = 0; group < auction.groupCount(); ++group)
      auction.setCandidates(group, leaves);
    auction.run(step * kIncrement * spread, kRoundsOfCells);
    for (std::size_t j = 0; j < level.size(); ++j)
      prices[j] = auction.price(j);
    solution.targetOf = completed(auction, level);
    solution.sourceCost.clear();
    for (std::size_t i = 0; i < level.size(); ++i)
      solution.sourceCost.push_back(auction.leastCost(i));
  }
  return solution;
}

/// Matches `fine`, starting from the matching of its cells. The finest level needs no dual
/// variables.
Solution solveFiner(const Level& cells, const Solution& coarse, const Level& fine, bool isFinest) {
  const Neighbours neighbours(cells.target);
  LeafAuction auction(fine.source, fine.target,
                      carriedOver(cells, coarse, neighbours, fine.target));
  tbb::parallel_for(std::size_t(0), auction.groupCount(),
                    [&](std::size_t group) { setCandidates(auction, group, coarse, neighbours); });
  auction.run(kIncrement * spreadOfCells(fine.target), isFinest ? kRoundsOfPoints : kRoundsOfCells);
  Solution solution{completed(auction, fine), {}};
  if (isFinest)
    return solution;
  solution.sourceCost.resize(fine.size());
  tbb::parallel_for(std::size_t(0), fine.size(),
                    [&](std::size_t i) { solution.sourceCost[i] = auction.leastCost(i); });
  return solution;
}

} // namespace

std::vector<std::uint32_t> multiscaleMatching(const PointPair& points, ProgressPart progress) {
  const PartitionOrder order = partitionOrder(points.source, points.target, kCell);
  progress.reach(0.4);
  std::vector<Level> levels{
      {reordered(points.source, order.source), reordered(points.target, order.target)}};
  while (levels.back().size() > kCoarsest)
    levels.push_back({centroids(levels.back().source), centroids(levels.back().target)});
  Solution solution = solveCoarsest(levels.back());
  for (std::size_t level = levels.size() - 1; level > 0; --level)
    solution = solveFiner(levels[level], solution, levels[level - 1], level == 1);
  std::vector<std::uint32_t> assignment(points.source.size());
  for (std::size_t k = 0; k < assignment.size(); ++k)
    assignment[order.source[k]] = order.target[solution.targetOf[k]];
  return assignment;
}

} // namespace lichen::transport
