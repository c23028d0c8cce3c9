// SPDX-License-Identifier: MIT
// From places in the world, which are doubles, to the floats that a device computes with: those
// relative to an origin near what is drawn. Subtracted in doubles, they are as exact ten million
// units away as at home.
#pragma once

#include <glm/glm.hpp>

namespace lichen::renderer {

[[nodiscard]] inline glm::vec3 relativeTo(const glm::dvec3& origin, const glm::dvec3& place) {
  return glm::vec3(place - origin);
}

/// What it places in the world is placed relative to the origin.
[[nodiscard]] inline glm::mat4 relativeTo(const glm::dvec3& origin,
                                          const glm::dmat4& worldFromObject) {
  glm::dmat4 placed = worldFromObject;
  placed[3] -= glm::dvec4(origin, 0.0);
  return glm::mat4(placed);
}

} // namespace lichen::renderer
