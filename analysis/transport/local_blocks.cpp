// SPDX-License-Identifier: MIT
// Improves a matching in blocks; assignment[i] is the target of source i and changes in place.
#include "local_blocks.h"

#include "cycle_canceling.h"
#include "random.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace lichen::transport {
namespace {

/// Pairs per exchange block. In the same time, blocks of 64 come nearer to the optimum than blocks
/// of 16 or 32 (docs/decisions/004-transport.md).
constexpr std::size_t kSwapBlockSize = 64;
/// Pairs per region, which is cut into blocks kRoundsInRegion times. At 28 bytes per pair, a region
/// fits the first-level cache.
constexpr std::size_t kRegionSize = 1024;
constexpr int kRoundsInRegion = 4;

/// Pairs per block that is solved exactly.
constexpr std::size_t kExactBlockSize = 48;

using Frame = std::array<Point, 3>;

Frame randomFrame(std::uint64_t seed) {
  const Point a = randomDirection(seed, 0);
  const Point b = randomDirection(seed, 1);
  // A vector orthogonal to a. Two random directions are never parallel to float precision.
  const Point cross{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  const float scale = 1.0f / std::sqrt(dot(cross, cross));
  const Point c{cross.x * scale, cross.y * scale, cross.z * scale};
  return {a, c, {a.y * c.z - a.z * c.y, a.z * c.x - a.x * c.z, a.x * c.y - a.y * c.x}};
}

struct Member {
  std::array<float, 3> position; ///< in the rotated frame
  std::uint32_t index;
};

/// Twice the midpoint of pair `index`.
Member member(const Point& source, const Point& target, const Frame& frame, std::size_t index) {
  const Point middle{source.x + target.x, source.y + target.y, source.z + target.z};
  return {{dot(middle, frame[0]), dot(middle, frame[1]), dot(middle, frame[2])},
          std::uint32_t(index)};
}

/// Pairs in an order in which runs of at most blockSize are spatial neighbours. The ends of the
/// runs depend only on the counts.
class BlockPartition {
public:
  BlockPartition(std::vector<Member> members, std::size_t blockSize)
      : members_(std::move(members)), blockCount_((members_.size() + blockSize - 1) / blockSize) {
    split(0, blockCount_);
  }

  [[nodiscard]] std::size_t count() const { return blockCount_; }
  [[nodiscard]] std::span<const Member> block(std::size_t b) const {
    return {members_.data() + boundary(b), boundary(b + 1) - boundary(b)};
  }

private:
  [[nodiscard]] std::size_t boundary(std::size_t b) const {
    return b * members_.size() / blockCount_;
  }

  void split(std::size_t firstBlock, std::size_t lastBlock) {
    if (lastBlock - firstBlock < 2)
      return;
    const std::size_t middleBlock = (firstBlock + lastBlock) / 2;
    const auto begin = members_.begin() + std::ptrdiff_t(boundary(firstBlock));
    const auto middle = members_.begin() + std::ptrdiff_t(boundary(middleBlock));
    const auto end = members_.begin() + std::ptrdiff_t(boundary(lastBlock));
    const std::size_t axis = widestAxis(&*begin, std::size_t(end - begin));
    std::nth_element(begin, middle, end, [axis](const Member& a, const Member& b) {
      return a.position[axis] < b.position[axis] ||
             (a.position[axis] == b.position[axis] && a.index < b.index);
    });
    const auto left = [&] { split(firstBlock, middleBlock); };
    const auto right = [&] { split(middleBlock, lastBlock); };
    if (std::size_t(end - begin) >= kTaskSize) {
      tbb::parallel_invoke(left, right);
    } else {
      left();
      right();
    }
  }

  static std::size_t widestAxis(const Member* members, std::size_t count) {
    std::array<float, 3> low = members[0].position;
    std::array<float, 3> high = low;
    for (std::size_t i = 1; i < count; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], members[i].position[axis]);
        high[axis] = std::max(high[axis], members[i].position[axis]);
      }
    std::size_t widest = 0;
    for (std::size_t axis = 1; axis < 3; ++axis)
      if (high[axis] - low[axis] > high[widest] - low[widest])
        widest = axis;
    return widest;
  }

  std::vector<Member> members_;
  std::size_t blockCount_;
};

BlockPartition partitionOf(const PointPair& points, std::span<const std::uint32_t> assignment,
                           std::size_t blockSize, std::uint64_t seed) {
  const Frame frame = randomFrame(seed);
  std::vector<Member> members(assignment.size());
  tbb::parallel_for(std::size_t(0), members.size(), [&](std::size_t i) {
    members[i] = member(points.source[i], points.target[assignment[i]], frame, i);
  });
  return {std::move(members), blockSize};
}

/// A block's points in contiguous arrays.
struct Gathered {
  std::vector<Point> source;
  std::vector<Point> target;
  std::vector<std::uint32_t> targetIndex;

  void gather(const PointPair& points, std::span<const std::uint32_t> assignment,
              std::span<const Member> block) {
    source.clear();
    target.clear();
    targetIndex.clear();
    for (const Member& member : block) {
      source.push_back(points.source[member.index]);
      targetIndex.push_back(assignment[member.index]);
      target.push_back(points.target[targetIndex.back()]);
    }
  }
};

/// Squared relative rounding error of a three-term product of floats: (2^-20)^2, a generous bound.
constexpr float kRoundingOfProduct = 1e-12f;

/// Pairs compared at once: one AVX-512 vector or two AVX2 vectors.
constexpr std::size_t kLanes = 16;

/// A block's points, one array per coordinate. Unused elements are NaN, which loses every
/// comparison.
struct SwapBlock {
  alignas(64) std::array<float, kSwapBlockSize> sx{}, sy{}, sz{}, tx{}, ty{}, tz{};
  std::array<std::uint32_t, kSwapBlockSize> targetPlace{}; ///< index into the region's pairs

  void swapTargets(std::size_t i, std::size_t j) {
    std::swap(tx[i], tx[j]);
    std::swap(ty[i], ty[j]);
    std::swap(tz[i], tz[j]);
    std::swap(targetPlace[i], targetPlace[j]);
  }
};

/// The pair whose exchange of targets with pair i gains most, by more than rounding; i if there is
/// none.
__attribute__((target_clones("avx512f", "avx2", "default"))) std::size_t
bestExchange(const SwapBlock& b, std::size_t i, std::size_t count) {
  alignas(64) float least[kLanes];
  alignas(64) std::int32_t place[kLanes];
  for (std::size_t k = 0; k < kLanes; ++k) {
    least[k] = 0.0f;
    place[k] = std::int32_t(i);
  }
  for (std::size_t first = 0; first < count; first += kLanes)
    for (std::size_t k = 0; k < kLanes; ++k) {
      const std::size_t j = first + k;
      const float sx = b.sx[i] - b.sx[j], sy = b.sy[i] - b.sy[j], sz = b.sz[i] - b.sz[j];
      const float tx = b.tx[i] - b.tx[j], ty = b.ty[i] - b.ty[j], tz = b.tz[i] - b.tz[j];
      const float product = sx * tx + sy * ty + sz * tz;
      const float rounding =
          kRoundingOfProduct * (sx * sx + sy * sy + sz * sz) * (tx * tx + ty * ty + tz * tz);
      const float gain = product * product > rounding ? product : 0.0f;
      place[k] = gain < least[k] ? std::int32_t(j) : place[k];
      least[k] = gain < least[k] ? gain : least[k];
    }
  std::size_t best = 0;
  for (std::size_t k = 1; k < kLanes; ++k)
    if (least[k] < least[best])
      best = k;
  return least[best] < 0.0f ? std::size_t(place[best]) : i;
}

/// A region's pairs, and memory for its blocks.
struct SwapWork {
  Gathered points;
  SwapBlock block;

  void improve(std::span<const Member> region, std::span<std::uint32_t> assignment,
               std::uint64_t seed) {
    for (int round = 0; round < kRoundsInRegion; ++round) {
      const Frame frame = randomFrame(randomBits(seed, std::uint64_t(round)));
      std::vector<Member> members(region.size());
      for (std::size_t i = 0; i < members.size(); ++i)
        members[i] = member(points.source[i], points.target[i], frame, i);
      const BlockPartition partition(std::move(members), kSwapBlockSize);
      for (std::size_t b = 0; b < partition.count(); ++b)
        improveBlock(partition.block(b));
    }
    for (std::size_t i = 0; i < region.size(); ++i)
      assignment[region[i].index] = points.targetIndex[i];
  }

  void improveBlock(std::span<const Member> members) {
    const std::size_t n = members.size();
    block.sx.fill(std::numeric_limits<float>::quiet_NaN());
    for (std::size_t k = 0; k < n; ++k) {
      const std::uint32_t i = members[k].index;
      block.sx[k] = points.source[i].x;
      block.sy[k] = points.source[i].y;
      block.sz[k] = points.source[i].z;
      block.tx[k] = points.target[i].x;
      block.ty[k] = points.target[i].y;
      block.tz[k] = points.target[i].z;
      block.targetPlace[k] = i;
    }
    // The pass limit ends loops of exchanges whose gain is only rounding.
    bool changed = true;
    for (std::size_t pass = 0; changed && pass < n; ++pass) {
      changed = false;
      for (std::size_t i = 0; i < n; ++i) {
        const std::size_t j = bestExchange(block, i, n);
        if (j != i) {
          block.swapTargets(i, j);
          changed = true;
        }
      }
    }
    write(members);
  }

  /// Writes the block's targets back to the region.
  void write(std::span<const Member> members) {
    std::array<std::uint32_t, kSwapBlockSize> indices;
    for (std::size_t k = 0; k < members.size(); ++k)
      indices[k] = points.targetIndex[block.targetPlace[k]];
    for (std::size_t k = 0; k < members.size(); ++k) {
      points.target[members[k].index] = {block.tx[k], block.ty[k], block.tz[k]};
      points.targetIndex[members[k].index] = indices[k];
    }
  }
};

struct ExactWork {
  Gathered points;
  CycleCanceling solver;

  void improve(std::span<const Member> block, std::span<std::uint32_t> assignment, std::uint64_t) {
    solver.solve(points.source, points.target, points.targetIndex);
    for (std::size_t i = 0; i < block.size(); ++i)
      assignment[block[i].index] = points.targetIndex[i];
  }
};

template <class Work>
void improveBlocks(const PointPair& points, std::span<std::uint32_t> assignment,
                   std::size_t blockSize, std::uint64_t seed) {
  const BlockPartition partition = partitionOf(points, assignment, blockSize, seed);
  tbb::enumerable_thread_specific<Work> works;
  tbb::parallel_for(std::size_t(0), partition.count(), [&](std::size_t b) {
    Work& work = works.local();
    work.points.gather(points, assignment, partition.block(b));
    work.improve(partition.block(b), assignment, randomBits(seed, b));
  });
}

} // namespace

void swapInsideRegions(const PointPair& points, std::span<std::uint32_t> assignment,
                       std::uint64_t seed) {
  improveBlocks<SwapWork>(points, assignment, kRegionSize, seed);
}

void solveInsideBlocks(const PointPair& points, std::span<std::uint32_t> assignment,
                       std::uint64_t seed) {
  improveBlocks<ExactWork>(points, assignment, kExactBlockSize, seed);
}

} // namespace lichen::transport
