// SPDX-License-Identifier: MIT
// Two directions across a third.
#pragma once

#include <glm/glm.hpp>

#include <cmath>

namespace lichen::renderer {

/// Right-handed and orthonormal, the third column being `z`, a unit vector.
[[nodiscard]] inline glm::mat3 frameAlong(glm::vec3 z) {
  constexpr float kSteep = 0.9f; // far enough from 1 for the cross product to keep its digits
  const glm::vec3 axis = std::abs(z.y) < kSteep ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 x = glm::normalize(glm::cross(axis, z));
  return {x, glm::cross(z, x), z};
}

} // namespace lichen::renderer
