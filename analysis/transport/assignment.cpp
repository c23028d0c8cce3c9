// SPDX-License-Identifier: MIT
// Transport between equal point sets: N points and N points -> a permutation.
// Random partition trees on preconditioned points, merged; then two-opt and exact blocks.
#include "assignment.h"

#include "local_blocks.h"
#include "partition_tree.h"
#include "precondition.h"
#include "random.h"

#include <cassert>

namespace lichen::transport {
namespace {

/// Pairs that swapInsideBlocks compares with each other: cheap, so more rounds of fewer.
constexpr int kSwapBlockSize = 16;

/// Salts, so that trees and block partitions draw from different streams.
constexpr std::uint64_t kTreeStream = 1;
constexpr std::uint64_t kSwapStream = 2;
constexpr std::uint64_t kExactStream = 3;

std::uint64_t streamSeed(std::uint64_t seed, std::uint64_t stream, int round) {
  return randomBits(seed * 4 + stream, std::uint64_t(round));
}

/// Takes over what a second matching does better: each of its pairs is tried as an exchange.
void merge(const PointPair& points, std::vector<std::uint32_t>& assignment,
           std::vector<std::uint32_t>& sourceOf, const std::vector<std::uint32_t>& other) {
  for (std::size_t i = 0; i < assignment.size(); ++i) {
    const std::size_t j = sourceOf[other[i]];
    const Point& si = points.source[i];
    const Point& sj = points.source[j];
    const Point& ti = points.target[assignment[i]];
    const Point& tj = points.target[assignment[j]];
    const Point ds{si.x - sj.x, si.y - sj.y, si.z - sj.z};
    const Point dt{ti.x - tj.x, ti.y - tj.y, ti.z - tj.z};
    if (dot(ds, dt) < 0.0f) {
      std::swap(assignment[i], assignment[j]);
      sourceOf[assignment[i]] = std::uint32_t(i);
      sourceOf[assignment[j]] = std::uint32_t(j);
    }
  }
}

std::vector<std::uint32_t> mergedTrees(const PointPair& points, const TransportOptions& options) {
  const auto tree = [&](int round) {
    return partitionTreeMatching(points.source, points.target,
                                 streamSeed(options.seed, kTreeStream, round));
  };
  std::vector<std::uint32_t> assignment = tree(0);
  std::vector<std::uint32_t> sourceOf(assignment.size());
  for (std::size_t i = 0; i < assignment.size(); ++i)
    sourceOf[assignment[i]] = std::uint32_t(i);
  for (int round = 1; round < options.trees; ++round)
    merge(points, assignment, sourceOf, tree(round));
  return assignment;
}

void improve(const PointPair& points, std::vector<std::uint32_t>& assignment,
             const TransportOptions& options) {
  for (int round = 0; round < options.swapRounds; ++round)
    swapInsideBlocks(points, assignment, kSwapBlockSize,
                     streamSeed(options.seed, kSwapStream, round));
  for (int round = 0; round < options.exactRounds; ++round) {
    options.progress.reach(double(round) / options.exactRounds);
    solveInsideBlocks(points, assignment, options.blockSize,
                      streamSeed(options.seed, kExactStream, round));
  }
}

} // namespace

TransportOptions optionsFor(TransportEffort effort) {
  switch (effort) {
  case TransportEffort::fast:
    return {.trees = 4, .swapRounds = 4, .exactRounds = 0};
  case TransportEffort::standard:
    break;
  case TransportEffort::exact:
    return {.exactRounds = 60};
  }
  return {};
}

std::vector<std::uint32_t> assign(std::span<const Point> source, std::span<const Point> target,
                                  const TransportOptions& options) {
  assert(source.size() == target.size());
  if (source.empty())
    return {};
  const PointPair points = precondition(source, target);
  std::vector<std::uint32_t> assignment = mergedTrees(points, options);
  improve(points, assignment, options);
  return assignment;
}

std::vector<std::uint32_t> improveAssignment(std::span<const Point> source,
                                             std::span<const Point> target,
                                             std::vector<std::uint32_t> start,
                                             const TransportOptions& options) {
  assert(source.size() == target.size() && source.size() == start.size());
  if (source.empty())
    return {};
  improve(precondition(source, target), start, options);
  return start;
}

double transportCost(std::span<const Point> source, std::span<const Point> target,
                     std::span<const std::uint32_t> assignment) {
  double sum = 0.0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const Point& s = source[i];
    const Point& t = target[assignment[i]];
    const double dx = double(s.x) - t.x;
    const double dy = double(s.y) - t.y;
    const double dz = double(s.z) - t.z;
    sum += dx * dx + dy * dy + dz * dz;
  }
  return source.empty() ? 0.0 : sum / double(source.size());
}

} // namespace lichen::transport
