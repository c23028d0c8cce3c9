// SPDX-License-Identifier: MIT
// Directions: vectors that may be zero, and frames.
#pragma once

#include <glm/glm.hpp>

#include <cmath>
#include <limits>

namespace lichen::renderer {

/// `v` normalised, or `fallback` if its length is 0 or not finite.
[[nodiscard]] inline glm::vec3 normalizedOr(glm::vec3 v, glm::vec3 fallback) {
  const float length = glm::length(v);
  const bool usable =
      length > std::numeric_limits<float>::min() && length <= std::numeric_limits<float>::max();
  return usable ? v / length : fallback;
}

/// A right-handed orthonormal frame whose third column is the unit vector `z`.
[[nodiscard]] inline glm::mat3 frameAlong(glm::vec3 z) {
  constexpr float kSteep = 0.9f; // far enough from 1 that the cross product keeps its precision
  const glm::vec3 axis = std::abs(z.y) < kSteep ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 x = glm::normalize(glm::cross(axis, z));
  return {x, glm::cross(z, x), z};
}

} // namespace lichen::renderer
