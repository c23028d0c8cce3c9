// SPDX-License-Identifier: MIT
// Caches the prefiltered built-in sky between pictures: preparing it takes longer than rendering a
// small picture.
#pragma once

#include "environment.h"

#include <glm/glm.hpp>

#include <optional>

namespace lichen::renderer {

struct PreparedSky {
  glm::vec3 balance{1.0f}; ///< see Sky
  Environment environment;
};

/// Holds the most recent sky. Not thread-safe.
class SkyCache {
public:
  /// makeSky() with these arguments, prefiltered; valid until the next call.
  [[nodiscard]] const PreparedSky& prepare(glm::vec3 towardSun, glm::vec3 sunlight,
                                           float irradiance);

private:
  struct Light {
    glm::vec3 towardSun, sunlight;
    float irradiance;
    bool operator==(const Light&) const = default;
  };
  std::optional<Light> light_;
  PreparedSky sky_;
};

} // namespace lichen::renderer
