// SPDX-License-Identifier: MIT
// Completes a direction to an orthonormal frame.
#pragma once

#include <glm/glm.hpp>

#include <cmath>

namespace lichen::renderer {

/// A right-handed orthonormal frame whose third column is the unit vector `z`.
[[nodiscard]] inline glm::mat3 frameAlong(glm::vec3 z) {
  constexpr float kSteep = 0.9f; // far enough from 1 that the cross product keeps its precision
  const glm::vec3 axis = std::abs(z.y) < kSteep ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 x = glm::normalize(glm::cross(axis, z));
  return {x, glm::cross(z, x), z};
}

} // namespace lichen::renderer
