// SPDX-License-Identifier: MIT
// Vectors in space, in the shader's precision.
#pragma once

#include <array>

namespace lichen::space {

using Vec3 = std::array<float, 3>;

[[nodiscard]] inline float dot(const Vec3& a, const Vec3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
/// a x + b y
[[nodiscard]] inline Vec3 combined(float a, const Vec3& x, float b, const Vec3& y) {
  return {a * x[0] + b * y[0], a * x[1] + b * y[1], a * x[2] + b * y[2]};
}
[[nodiscard]] inline Vec3 scaled(float a, const Vec3& x) { return {a * x[0], a * x[1], a * x[2]}; }
[[nodiscard]] inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

} // namespace lichen::space
