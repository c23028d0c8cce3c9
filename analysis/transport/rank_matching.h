// SPDX-License-Identifier: MIT
// Transport between points on a line.
#pragma once

#include "point.h"

#include <cstdint>
#include <vector>

namespace lichen::transport {

/// For each source the target of the same rank, by the first coordinates, and by index where they
/// are equal: the optimal transport on a line. N log N.
[[nodiscard]] std::vector<Point> matchedByRank(const std::vector<Point>& sources,
                                               const std::vector<Point>& targets);

/// As above, for sources whose indices in ascending order are `order`.
[[nodiscard]] std::vector<Point> matchedInOrder(const std::vector<std::uint32_t>& order,
                                                const std::vector<Point>& targets);

} // namespace lichen::transport
