// SPDX-License-Identifier: MIT
// Normalises a scene's lights to one scale, and adds a sun and a sky where the scene has none.
#pragma once

#include "framing.h"
#include "scene.h"

#include <vector>

namespace lichen::renderer {

struct Lighting {
  /// Lights in the renderer's scale: a white matte surface that faces the strongest light and the
  /// sky has a radiance of a little over 1. The sun comes first if there is one, then the others by
  /// irradiance at the subject, strongest first. At most MAX_LIGHTS.
  std::vector<Light> lights;
  std::size_t dropped = 0; ///< number of the scene's lights beyond MAX_LIGHTS
  bool hasSun = false;
  glm::vec3 towardSun{0.0f, 1.0f, 0.0f}; ///< direction of the sun in the built-in sky
  float skyIrradiance = 0.0f; ///< irradiance of the built-in sky on level ground; 0 without it
};

/// glTF states light in lux and candela, but exporters use units of their own, so only ratios
/// matter: the strongest light's irradiance at the subject becomes kKeyIrradiance. A scene without
/// lights gets a default sun, unless an environment file lights it.
[[nodiscard]] Lighting arrangeLights(const Scene& scene, const Sphere& subject,
                                     bool environmentFile);

} // namespace lichen::renderer
