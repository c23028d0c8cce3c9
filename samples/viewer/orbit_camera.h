// SPDX-License-Identifier: MIT
// A camera that orbits a point: mouse drags -> a pose.
#pragma once

#include "framing.h"

namespace lichen::renderer {

/// Returns exactly the camera it started from until it moves; after that it keeps the lens and
/// stays upright, with +y up. Drags are in window heights, x to the right and y down.
class OrbitCamera {
public:
  /// Orbits the point on the viewing axis that is closest to the subject's centre.
  OrbitCamera(const Camera& start, const Sphere& subject);

  /// A drag of one window height turns by half a circle. The elevation stops short of the poles.
  void turn(glm::vec2 drag);
  /// Points at the distance of the orbit's centre follow the mouse.
  void pan(glm::vec2 drag);
  /// Positive steps move closer, each by the same factor.
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
