// SPDX-License-Identifier: MIT
// One binary partition of two point sets.
#pragma once

#include "point.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lichen::transport {

/// Orders of two sets whose cells correspond: source[k] and target[k] with k in [r * leafSize, (r +
/// 1) * leafSize) are the points of cell r in each set. Cells that are close in the order are close
/// in space.
struct PartitionOrder {
  std::vector<std::uint32_t> source;
  std::vector<std::uint32_t> target;
};

/// Halves both sets across the direction in which the two together vary most, then halves each
/// half, down to cells of `leafSize` points: binary-partition matching [G25] section 4, which draws
/// random directions instead. A leaf size of 1 matches points. Both sets have the same size. The
/// result does not depend on the number of threads.
[[nodiscard]] PartitionOrder partitionOrder(std::span<const Point> source,
                                            std::span<const Point> target, std::size_t leafSize);

} // namespace lichen::transport
