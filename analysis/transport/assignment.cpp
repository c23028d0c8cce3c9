// SPDX-License-Identifier: MIT
// Transport between point sets of equal size: N points and N points -> a permutation.
// Multiscale matching of preconditioned points, then two-opt and exact blocks.
#include "assignment.h"

#include "local_blocks.h"
#include "multiscale.h"
#include "partition_tree.h"
#include "precondition.h"
#include "random.h"

#include <cassert>

namespace lichen::transport {
namespace {

/// The time of the multiscale matching in rounds of exchanges, for the progress only: 0.15 s
/// against 0.05 s at 65,536 points (docs/decisions/004-transport.md). A round of exact
/// blocks counts as one round.
constexpr double kMultiscaleWork = 3.0;

/// Seeds that give the two kinds of block different random numbers.
constexpr std::uint64_t kSwapSeed = 6;
constexpr std::uint64_t kExactSeed = 7;

/// The matching of two sets on a line.
std::vector<std::uint32_t> sorted(const PointPair& points) {
  const PartitionOrder order = partitionOrder(points.source, points.target, 1);
  std::vector<std::uint32_t> assignment(points.source.size());
  for (std::size_t k = 0; k < assignment.size(); ++k)
    assignment[order.source[k]] = order.target[k];
  return assignment;
}

void improve(const PointPair& points, std::vector<std::uint32_t>& assignment,
             const TransportOptions& options, ProgressPart progress) {
  const double rounds = options.swapRounds + options.exactRounds;
  for (int round = 0; round < options.swapRounds; ++round) {
    progress.reach(round / rounds);
    swapInsideRegions(points, assignment, randomBits(kSwapSeed, std::uint64_t(round)));
  }
  for (int round = 0; round < options.exactRounds; ++round) {
    progress.reach((options.swapRounds + round) / rounds);
    solveInsideBlocks(points, assignment, randomBits(kExactSeed, std::uint64_t(round)));
  }
}

} // namespace

std::vector<std::uint32_t> assign(std::span<const Point> source, std::span<const Point> target,
                                  const TransportOptions& options) {
  assert(source.size() == target.size());
  if (source.empty())
    return {};
  const PointPair points = precondition(source, target);
  if (points.dimensions < 2)
    return sorted(points);
  const double multiscale =
      kMultiscaleWork / (kMultiscaleWork + options.swapRounds + options.exactRounds);
  std::vector<std::uint32_t> assignment =
      multiscaleMatching(points, options.progress.part(0.0, multiscale));
  improve(points, assignment, options, options.progress.part(multiscale, 1.0));
  return assignment;
}

std::vector<std::uint32_t> improveAssignment(std::span<const Point> source,
                                             std::span<const Point> target,
                                             std::vector<std::uint32_t> start,
                                             const TransportOptions& options) {
  assert(source.size() == target.size() && source.size() == start.size());
  if (source.empty())
    return {};
  improve(precondition(source, target), start, options, options.progress);
  return start;
}

} // namespace lichen::transport
