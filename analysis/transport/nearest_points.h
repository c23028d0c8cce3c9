// SPDX-License-Identifier: MIT
// Nearest neighbours among many points, by a tree of boxes over their order.
#pragma once

#include "point_arrays.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lichen::transport {

/// Fast if points that are close in their order are close in space (PartitionOrder). Holds a
/// reference to the points.
class NearestPoints {
public:
  static constexpr std::size_t kMostWanted = 16;

  explicit NearestPoints(const PointArrays& points);

  /// Fills `nearest` with the indices of the nearest points, nearest first. Returns how many it
  /// found: the least of nearest.size(), kMostWanted and the number of points. Thread-safe.
  std::size_t find(const Point& at, std::span<std::uint32_t> nearest) const;

private:
  struct Box {
    std::array<float, 3> low;
    std::array<float, 3> high;
  };

  [[nodiscard]] float squaredDistance(std::size_t node, const Point& at) const;

  const PointArrays& points_;
  std::size_t leafCount_ = 1;
  std::vector<Box> boxes_; ///< node k has the children 2 k and 2 k + 1; the root is 1
};

} // namespace lichen::transport
