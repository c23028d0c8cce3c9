// SPDX-License-Identifier: MIT
// The points that transport matches.
#pragma once

namespace lichen {

/// A point of R^3. Problems of fewer dimensions set the other coordinates to 0.
struct Point {
  float x = 0.0f;
  float y = 0.0f;
  float z = 0.0f;
};

[[nodiscard]] inline float dot(const Point& a, const Point& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

} // namespace lichen
