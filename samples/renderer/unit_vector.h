// SPDX-License-Identifier: MIT
// Normalises vectors that may be zero.
#pragma once

#include <glm/glm.hpp>

#include <limits>

namespace lichen::renderer {

/// `v` normalised, or `fallback` if its length is 0 or not finite.
[[nodiscard]] inline glm::vec3 normalizedOr(glm::vec3 v, glm::vec3 fallback) {
  const float length = glm::length(v);
  const bool usable =
      length > std::numeric_limits<float>::min() && length <= std::numeric_limits<float>::max();
  return usable ? v / length : fallback;
}

} // namespace lichen::renderer
