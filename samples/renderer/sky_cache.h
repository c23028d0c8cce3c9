// SPDX-License-Identifier: MIT
// The built-in sky, prepared for shading, kept from one picture to the next: to prepare it takes
// longer than to draw a small picture.
#pragma once

#include "environment.h"

#include <glm/glm.hpp>

#include <optional>

namespace lichen::renderer {

struct PreparedSky {
  glm::vec3 balance{1.0f}; ///< see Sky
  Environment environment;
};

/// Holds the last sky asked for. Not for several threads at once.
class SkyCache {
public:
  /// makeSky() of these, prepared; valid until the next call.
  [[nodiscard]] const PreparedSky& under(glm::vec3 towardSun, glm::vec3 sunlight, float irradiance);

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
