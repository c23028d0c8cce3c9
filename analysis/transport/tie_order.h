// SPDX-License-Identifier: MIT
// Ascending orders of values, and orders in which scores break the ties.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace lichen::transport {

/// Indices by ascending value; the index breaks ties. O(N log N).
[[nodiscard]] std::vector<std::uint32_t> ascendingOrder(std::span<const float> values);

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
