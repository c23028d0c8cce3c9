// SPDX-License-Identifier: MIT
// A camera that turns around a point: a drag of the mouse -> a pose.
#pragma once

#include "framing.h"

namespace lichen::renderer {

/// Is exactly the camera that it started from until it is moved; then it has that camera's lens and
/// stands upright, with +y up. Lengths of drags are in heights of the window, x to the right and y
/// downwards.
class OrbitCamera {
public:
  /// Turns around the point of the line of sight that is nearest to the subject's middle.
  OrbitCamera(const Camera& start, const Sphere& subject);

  /// A drag of a whole height turns by half a circle. The pole is never reached.
  void turn(glm::vec2 drag);
  /// What is as far as the point that it turns around follows the mouse.
  void pan(glm::vec2 drag);
  /// Positive steps come closer, each by the same factor.
  void zoom(float steps);

  [[nodiscard]] Camera camera() const;

private:
  [[nodiscard]] glm::mat3 axes() const; ///< right, up, backwards
  [[nodiscard]] float halfHeight() const;

  Camera start_;
  bool moved_ = false;
  glm::dvec3 target_{0.0};
  float distance_ = 1.0f;
  float leastDistance_ = 0.0f;
  float mostDistance_ = 0.0f;
  float azimuth_ = 0.0f;   ///< radians, from +z toward +x
  float elevation_ = 0.0f; ///< radians, above the horizon
};

} // namespace lichen::renderer
