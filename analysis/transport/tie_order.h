// SPDX-License-Identifier: MIT
// Orders on a line, and the freedom that they leave: that of pixels of equal value.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace lichen::transport {

/// Indices by value, and by index where values are equal: N log N.
[[nodiscard]] std::vector<std::uint32_t> ascendingOrder(std::span<const float> values);

/// Pixels in the order of their values, which stays.
class TieOrder {
public:
  explicit TieOrder(std::span<const float> values);

  /// The pixels by value, by score where values are equal, and then by index.
  [[nodiscard]] std::vector<std::uint32_t> by(std::span<const float> scores) const;

private:
  std::vector<std::uint32_t> order_; ///< of pixels, by value and then by index
  std::vector<std::uint32_t> ties_;  ///< where in it each value begins, and the end
};

} // namespace lichen::transport
