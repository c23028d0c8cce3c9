// SPDX-License-Identifier: MIT
// Optimal transport between points on a line.
#pragma once

#include "point.h"

#include <cstdint>
#include <span>
#include <vector>

namespace lichen::transport {

/// Returns, for each source, the target of the same rank in the first coordinate; the index breaks
/// ties. This is the optimal transport on a line. O(N log N).
[[nodiscard]] std::vector<Point> matchedByRank(const std::vector<Point>& sources,
                                               const std::vector<Point>& targets);

/// Like matchedByRank(), for sources that `order` lists in ascending order.
[[nodiscard]] std::vector<Point> matchedInOrder(const std::vector<std::uint32_t>& order,
                                                const std::vector<Point>& targets);

/// The fixed order of pixels by value, whose ties a score can break.
class TieOrder {
public:
  explicit TieOrder(std::span<const float> values);

  /// The pixels by value, then by score, then by index.
  [[nodiscard]] std::vector<std::uint32_t> by(std::span<const float> scores) const;

private:
  std::vector<std::uint32_t> order_; ///< the pixels, by value and then by index
  std::vector<std::uint32_t> ties_;  ///< the first position of each value in order_, and the end
};

} // namespace lichen::transport
