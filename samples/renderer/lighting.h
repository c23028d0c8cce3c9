// SPDX-License-Identifier: MIT
// A scene's lights brought to one scale, with a sun and a sky where the scene has none.
#pragma once

#include "framing.h"
#include "scene.h"

#include <vector>

namespace lichen::renderer {

struct Lighting {
  /// Lights in the renderer's scale: a white matte surface that faces the strongest one and the sky
  /// has a radiance of a little over 1. The sun, if there is one, is first; the others follow from
  /// the one that lights the subject most. At most MAX_LIGHTS.
  std::vector<Light> lights;
  std::size_t dropped = 0; ///< lights of the scene beyond MAX_LIGHTS
  bool hasSun = false;
  glm::vec3 towardSun{0.0f, 1.0f, 0.0f}; ///< where the built-in sky glows
  float skyIrradiance = 0.0f;            ///< of the built-in sky on level ground; 0 without it
};

/// Files state light in lux and candela, exporters in units of their own, so only ratios are kept:
/// the strongest light's irradiance at the subject becomes kKeyIrradiance. Without any light there
/// is a default sun, unless an environment file brings the light.
[[nodiscard]] Lighting arrangeLights(const Scene& scene, const Sphere& subject,
                                     bool environmentFile);

} // namespace lichen::renderer
