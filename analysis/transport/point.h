// SPDX-License-Identifier: MIT
// The points that transport matches.
#pragma once

#include <cstddef>

namespace lichen {

/// A point of R^3. Problems of fewer dimensions set the other coordinates to 0.
struct Point {
  float x = 0.0f;
  float y = 0.0f;
  float z = 0.0f;
};

namespace transport {
/// Parts of a set with fewer points do not get a task of their own. At ten nanoseconds or more per
/// point, this many take a hundred times the microsecond that a task costs.
inline constexpr std::size_t kTaskSize = 8192;
} // namespace transport

[[nodiscard]] inline float dot(const Point& a, const Point& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

} // namespace lichen
