// SPDX-License-Identifier: MIT
// Built-in daylight: the light of a clear sky by direction, without the sun itself.
#pragma once

#include <lichen/image.h>

#include <glm/glm.hpp>

namespace lichen::renderer {

struct Sky {
  /// A latitude-longitude panorama of linear RGB radiance, 2:1, +y up at the top row, -z in the
  /// middle column, +x a quarter to its right. Below the horizon lies ground.
  LinearImage panorama;
  /// Factor of the sun's colour that goes with the panorama: see `sunlight`.
  glm::vec3 balance{1.0f};
};

/// The sky lays `irradiance` (mean of the channels) on level ground. `towardSun` is a unit vector;
/// a sun lower than 3 degrees is treated as at 3 degrees. `sunlight` is the irradiance of the sun
/// on a surface that faces it. White balance: sky and sun together are neutral on level ground, as
/// a camera set to daylight sees them, so that base colours keep their hue.
[[nodiscard]] Sky makeSky(glm::vec3 towardSun, glm::vec3 sunlight, float irradiance, int height);

/// Direction of a panorama's texel coordinate (u, v) in [0, 1]^2, and back.
[[nodiscard]] glm::vec3 panoramaDirection(glm::vec2 uv);
[[nodiscard]] glm::vec2 panoramaCoordinate(glm::vec3 direction);

} // namespace lichen::renderer
