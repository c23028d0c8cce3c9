// SPDX-License-Identifier: MIT
// Built-in daylight: radiance of a clear sky by direction, without the sun itself.
#pragma once

#include <lichen/image.h>

#include <glm/glm.hpp>

namespace lichen::renderer {

struct Sky {
  /// A latitude-longitude panorama of linear RGB radiance, 2:1. The top row is +y, the middle
  /// column -z, and +x is a quarter of the width to its right. Ground fills the part below the
  /// horizon.
  LinearImage panorama;
  /// White balance applied to the panorama; multiply the sun's colour by it.
  glm::vec3 balance{1.0f};
};

/// `irradiance` is the sky's irradiance on level ground (mean of the channels). `towardSun` is a
/// unit vector; a sun below 3 degrees is raised to 3 degrees. `sunlight` is the sun's irradiance on
/// a surface that faces it. White balance: sky and sun together are neutral on level ground, like a
/// camera set to daylight, so base colours keep their hue.
[[nodiscard]] Sky makeSky(glm::vec3 towardSun, glm::vec3 sunlight, float irradiance, int height);

/// Direction for a panorama's texture coordinate (u, v) in [0, 1]^2, and its inverse.
[[nodiscard]] glm::vec3 panoramaDirection(glm::vec2 uv);
[[nodiscard]] glm::vec2 panoramaCoordinate(glm::vec3 direction);

} // namespace lichen::renderer
