// SPDX-License-Identifier: MIT
// One binary partition of two point sets at once.
#pragma once

#include "point.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lichen::transport {

/// Two sets in an order in which their runs correspond: the points source[k] and target[k] with k
/// in [r * leafSize, (r + 1) * leafSize) fill cell r of both sets, and cells that are close in the
/// order are close in space.
struct PartitionOrder {
  std::vector<std::uint32_t> source;
  std::vector<std::uint32_t> target;
};

/// Halves both sets along one direction, that of the largest variance of the two together, and the
/// halves likewise down to cells of `leafSize` points: binary-partition matching [G25 section 4],
/// whose directions are random there. With a leaf size of 1 it matches points. Both sets have one
/// size. The same result for any number of threads.
[[nodiscard]] PartitionOrder partitionOrder(std::span<const Point> source,
                                            std::span<const Point> target, std::size_t leafSize);

} // namespace lichen::transport
