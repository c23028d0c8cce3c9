// SPDX-License-Identifier: MIT
// Converts world positions, which are doubles, into floats relative to an origin near the camera.
// The subtraction happens in doubles, so positions ten million units from the world's origin are as
// precise as those next to it.
#pragma once

#include <glm/glm.hpp>

namespace lichen::renderer {

[[nodiscard]] inline glm::vec3 relativeTo(const glm::dvec3& origin, const glm::dvec3& position) {
  return glm::vec3(position - origin);
}

/// `worldFromObject` with its translation relative to `origin`.
[[nodiscard]] inline glm::mat4 relativeTo(const glm::dvec3& origin,
                                          const glm::dmat4& worldFromObject) {
  glm::dmat4 relative = worldFromObject;
  relative[3] -= glm::dvec4(origin, 0.0);
  return glm::mat4(relative);
}

} // namespace lichen::renderer
