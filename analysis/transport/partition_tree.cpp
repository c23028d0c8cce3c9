// SPDX-License-Identifier: MIT
// Binary partition of two sets of N points -> two orders of N indices.
#include "partition_tree.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace lichen::transport {
namespace {

/// Power iterations for a split's direction. Any direction makes a valid split; one near the
/// principal axis makes round cells.
constexpr int kPowerSteps = 8;

struct KeyedPoint {
  Point point;
  std::uint32_t index;
  float key;
};

bool byKeyThenIndex(const KeyedPoint& a, const KeyedPoint& b) {
  return a.key < b.key || (a.key == b.key && a.index < b.index);
}

/// Sums that determine the covariance of points.
struct Sums {
  double count = 0.0;
  std::array<double, 3> first{};
  std::array<double, 6> second{}; ///< xx xy xz yy yz zz

  void add(const Point& p) {
    const double x = p.x, y = p.y, z = p.z;
    count += 1.0;
    first[0] += x;
    first[1] += y;
    first[2] += z;
    second[0] += x * x;
    second[1] += x * y;
    second[2] += x * z;
    second[3] += y * y;
    second[4] += y * z;
    second[5] += z * z;
  }

  /// About the direction of largest variance; an arbitrary direction if there is no variance.
  [[nodiscard]] Point principalAxis() const {
    const auto& [sx, sy, sz] = first;
    const double xx = second[0] - sx * sx / count, xy = second[1] - sx * sy / count,
                 xz = second[2] - sx * sz / count, yy = second[3] - sy * sy / count,
                 yz = second[4] - sy * sz / count, zz = second[5] - sz * sz / count;
    // The start is along no axis or diagonal, so it is not orthogonal to the principal axis of sets
    // that are aligned with the axes.
    std::array<double, 3> v{0.74, 0.52, 0.43};
    for (int step = 0; step < kPowerSteps; ++step) {
      const std::array<double, 3> next{xx * v[0] + xy * v[1] + xz * v[2],
                                       xy * v[0] + yy * v[1] + yz * v[2],
                                       xz * v[0] + yz * v[1] + zz * v[2]};
      const double length = std::sqrt(next[0] * next[0] + next[1] * next[1] + next[2] * next[2]);
      if (!(length > 0.0))
        break;
      v = {next[0] / length, next[1] / length, next[2] / length};
    }
    return {float(v[0]), float(v[1]), float(v[2])};
  }
};

class Partition {
public:
  Partition(std::span<const Point> source, std::span<const Point> target, std::size_t leafSize)
      : leafSize_(leafSize), source_(keyed(source)), target_(keyed(target)) {
    split(0, std::bit_ceil((source.size() + leafSize - 1) / leafSize));
  }

  [[nodiscard]] PartitionOrder order() const { return {indices(source_), indices(target_)}; }

private:
  static std::vector<KeyedPoint> keyed(std::span<const Point> points) {
    std::vector<KeyedPoint> result(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      result[i] = {points[i], std::uint32_t(i), 0.0f};
    return result;
  }

  static std::vector<std::uint32_t> indices(const std::vector<KeyedPoint>& points) {
    std::vector<std::uint32_t> result(points.size());
    std::transform(points.begin(), points.end(), result.begin(),
                   [](const KeyedPoint& p) { return p.index; });
    return result;
  }

  static void splitAt(KeyedPoint* begin, KeyedPoint* middle, KeyedPoint* end,
                      const Point& direction) {
    for (KeyedPoint* p = begin; p != end; ++p)
      p->key = dot(p->point, direction);
    std::nth_element(begin, middle, end, byKeyThenIndex);
  }

  /// Splits the cells [firstLeaf, lastLeaf); their number is a power of two, and the last may be
  /// empty.
  void split(std::size_t firstLeaf, std::size_t lastLeaf) {
    const std::size_t begin = firstLeaf * leafSize_;
    const std::size_t end = std::min(lastLeaf * leafSize_, source_.size());
    if (lastLeaf - firstLeaf < 2 || begin >= end)
      return;
    const std::size_t middleLeaf = (firstLeaf + lastLeaf) / 2;
    const std::size_t middle = middleLeaf * leafSize_;
    if (middle < end) {
      Sums sums;
      for (std::size_t i = begin; i < end; ++i) {
        sums.add(source_[i].point);
        sums.add(target_[i].point);
      }
      const Point direction = sums.principalAxis();
      splitAt(&source_[begin], &source_[middle], source_.data() + end, direction);
      splitAt(&target_[begin], &target_[middle], target_.data() + end, direction);
    }
    const auto left = [&] { split(firstLeaf, middleLeaf); };
    const auto right = [&] { split(middleLeaf, lastLeaf); };
    if (end - begin >= kTaskSize) {
      tbb::parallel_invoke(left, right);
    } else {
      left();
      right();
    }
  }

  std::size_t leafSize_;
  std::vector<KeyedPoint> source_;
  std::vector<KeyedPoint> target_;
};

} // namespace

PartitionOrder partitionOrder(std::span<const Point> source, std::span<const Point> target,
                              std::size_t leafSize) {
  return Partition(source, target, leafSize).order();
}

} // namespace lichen::transport
