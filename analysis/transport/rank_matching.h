// SPDX-License-Identifier: MIT
// Optimal transport between points on a line.
#pragma once

#include "point.h"

#include <cstdint>
#include <vector>

namespace lichen::transport {

/// Returns, for each source, the target of the same rank in the first coordinate; the index breaks
/// ties. This is the optimal transport on a line. O(N log N).
[[nodiscard]] std::vector<Point> matchedByRank(const std::vector<Point>& sources,
                                               const std::vector<Point>& targets);

/// Like matchedByRank(), for sources that `order` lists in ascending order.
[[nodiscard]] std::vector<Point> matchedInOrder(const std::vector<std::uint32_t>& order,
                                                const std::vector<Point>& targets);

} // namespace lichen::transport
