// SPDX-License-Identifier: MIT
// Random binary-partition matching; N points and N points -> a permutation.
#include "partition_tree.h"

#include "random.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <utility>

namespace lichen::transport {
namespace {

/// Below this, a subtree is too short to be worth a task of its own.
constexpr std::size_t kTaskSize = 8192;

struct KeyedPoint {
  Point point;
  std::uint32_t index;
  float key;
};

bool byKeyThenIndex(const KeyedPoint& a, const KeyedPoint& b) {
  return a.key < b.key || (a.key == b.key && a.index < b.index);
}

class Matching {
public:
  Matching(std::span<const Point> source, std::span<const Point> target, std::uint64_t seed)
      : seed_(seed), assignment_(source.size()), source_(keyed(source)), target_(keyed(target)) {}

  std::vector<std::uint32_t> run() {
    match(0, source_.size(), 1);
    return std::move(assignment_);
  }

private:
  static std::vector<KeyedPoint> keyed(std::span<const Point> points) {
    std::vector<KeyedPoint> result(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      result[i] = {points[i], std::uint32_t(i), 0.0f};
    return result;
  }

  static void splitAt(KeyedPoint* begin, std::size_t count, std::size_t middle,
                      const Point& direction) {
    for (KeyedPoint* p = begin; p != begin + count; ++p)
      p->key = dot(p->point, direction);
    std::nth_element(begin, begin + middle, begin + count, byKeyThenIndex);
  }

  /// Matches the points [first, first + count) of both arrays; `node` numbers the tree's nodes.
  void match(std::size_t first, std::size_t count, std::uint64_t node) {
    if (count == 0)
      return;
    if (count == 1) {
      assignment_[source_[first].index] = target_[first].index;
      return;
    }
    const Point direction = randomDirection(seed_, node);
    const std::size_t middle = count / 2;
    splitAt(&source_[first], count, middle, direction);
    splitAt(&target_[first], count, middle, direction);
    const auto left = [&] { match(first, middle, 2 * node); };
    const auto right = [&] { match(first + middle, count - middle, 2 * node + 1); };
    if (count >= kTaskSize) {
      tbb::parallel_invoke(left, right);
    } else {
      left();
      right();
    }
  }

  std::uint64_t seed_;
  std::vector<std::uint32_t> assignment_;
  std::vector<KeyedPoint> source_;
  std::vector<KeyedPoint> target_;
};

} // namespace

std::vector<std::uint32_t> partitionTreeMatching(std::span<const Point> source,
                                                 std::span<const Point> target,
                                                 std::uint64_t seed) {
  return Matching(source, target, seed).run();
}

} // namespace lichen::transport
