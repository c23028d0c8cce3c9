// SPDX-License-Identifier: MIT
// Block-wise improvement of a matching; assignment[i] is the target of source i, changed in place.
#include "local_blocks.h"

#include "cycle_canceling.h"
#include "random.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace lichen::transport {
namespace {

/// Below this, a part is too short to be worth a task of its own.
constexpr std::size_t kTaskSize = 8192;

using Frame = std::array<Point, 3>;

Frame randomFrame(std::uint64_t seed) {
  const Point a = randomDirection(seed, 0);
  const Point b = randomDirection(seed, 1);
  // A vector orthogonal to a; two random directions are never parallel to float precision.
  const Point cross{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  const float scale = 1.0f / std::sqrt(dot(cross, cross));
  const Point c{cross.x * scale, cross.y * scale, cross.z * scale};
  return {a, c, {a.y * c.z - a.z * c.y, a.z * c.x - a.x * c.z, a.x * c.y - a.y * c.x}};
}

struct Member {
  std::array<float, 3> position; ///< in the rotated frame
  std::uint32_t index;
};

/// The pairs, ordered so that runs of at most blockSize are spatial neighbours; where the runs end
/// follows from the counts alone.
class BlockPartition {
public:
  BlockPartition(const PointPair& points, std::span<const std::uint32_t> assignment, int blockSize,
                 std::uint64_t seed)
      : members_(points.source.size()),
        blockCount_((members_.size() + std::size_t(blockSize) - 1) / std::size_t(blockSize)) {
    const Frame frame = randomFrame(seed);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, members_.size(), kTaskSize),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                        for (std::size_t i = range.begin(); i != range.end(); ++i) {
                          const Point& s = points.source[i];
                          const Point& t = points.target[assignment[i]];
                          const Point middle{s.x + t.x, s.y + t.y, s.z + t.z};
                          members_[i].index = std::uint32_t(i);
                          for (std::size_t axis = 0; axis < 3; ++axis)
                            members_[i].position[axis] = dot(middle, frame[axis]);
                        }
                      });
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

/// A block's points, gathered.
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

/// Squared relative rounding error of a three-term product of floats, (2^-20)^2 with room to spare.
constexpr float kRoundingOfProduct = 1e-12f;

struct SwapWork {
  Gathered points;

  void improve(std::span<const Member> block, std::span<std::uint32_t> assignment) {
    const std::size_t n = block.size();
    // Exchanges that rounding alone calls improvements could go in circles: the passes are counted.
    bool changed = true;
    for (std::size_t pass = 0; changed && pass < n; ++pass) {
      changed = false;
      for (std::size_t i = 0; i + 1 < n; ++i)
        for (std::size_t j = i + 1; j < n; ++j) {
          const Point ds{points.source[i].x - points.source[j].x,
                         points.source[i].y - points.source[j].y,
                         points.source[i].z - points.source[j].z};
          const Point dt{points.target[i].x - points.target[j].x,
                         points.target[i].y - points.target[j].y,
                         points.target[i].z - points.target[j].z};
          const float product = dot(ds, dt);
          if (product < 0.0f &&
              product * product > kRoundingOfProduct * dot(ds, ds) * dot(dt, dt)) {
            std::swap(points.target[i], points.target[j]);
            std::swap(points.targetIndex[i], points.targetIndex[j]);
            changed = true;
          }
        }
    }
    for (std::size_t i = 0; i < n; ++i)
      assignment[block[i].index] = points.targetIndex[i];
  }
};

struct ExactWork {
  Gathered points;
  CycleCanceling solver;

  void improve(std::span<const Member> block, std::span<std::uint32_t> assignment) {
    solver.solve(points.source, points.target, points.targetIndex);
    for (std::size_t i = 0; i < block.size(); ++i)
      assignment[block[i].index] = points.targetIndex[i];
  }
};

template <class Work>
void improveBlocks(const PointPair& points, std::span<std::uint32_t> assignment, int blockSize,
                   std::uint64_t seed) {
  const BlockPartition partition(points, assignment, blockSize, seed);
  tbb::enumerable_thread_specific<Work> works;
  tbb::parallel_for(std::size_t(0), partition.count(), [&](std::size_t b) {
    Work& work = works.local();
    work.points.gather(points, assignment, partition.block(b));
    work.improve(partition.block(b), assignment);
  });
}

} // namespace

void swapInsideBlocks(const PointPair& points, std::span<std::uint32_t> assignment, int blockSize,
                      std::uint64_t seed) {
  improveBlocks<SwapWork>(points, assignment, blockSize, seed);
}

void solveInsideBlocks(const PointPair& points, std::span<std::uint32_t> assignment, int blockSize,
                       std::uint64_t seed) {
  improveBlocks<ExactWork>(points, assignment, blockSize, seed);
}

} // namespace lichen::transport
