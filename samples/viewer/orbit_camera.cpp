// SPDX-License-Identifier: MIT
// Stores the pose as a point, a distance and two angles, so that rounding cannot tilt the camera.
#include "orbit_camera.h"

#include "relative_to.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lichen::renderer {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kHighest = 0.49f * kPi; // short of the pole, where the azimuth is undefined
constexpr float kZoomStep = 1.1f; // per notch of the mouse wheel: seven notches double the size
// In subject radii. Closer, single texels fill the window; farther, the subject is one pixel.
constexpr float kLeastDistance = 1e-3f;
constexpr float kMostDistance = 1e3f;
// Near plane as a share of the distance, when the camera moves close.
constexpr float kNearShare = 0.02f;

} // namespace

OrbitCamera::OrbitCamera(const Camera& start, const Sphere& subject)
    : start_(start), leastDistance_(kLeastDistance * subject.radius),
      mostDistance_(kMostDistance * subject.radius) {
  const glm::vec3 backwards = glm::normalize(glm::vec3(start.worldFromCamera[2]));
  const float along = glm::dot(relativeTo(subject.center, eyeOf(start)), backwards);
  // A camera that looks away from the subject, for example inside a room, orbits a point in front
  // of it.
  distance_ = std::clamp(along > 0.0f ? along : subject.radius, leastDistance_, mostDistance_);
  target_ = eyeOf(start) - glm::dvec3(backwards * distance_);
  azimuth_ = std::atan2(backwards.x, backwards.z);
  elevation_ = std::clamp(std::asin(std::clamp(backwards.y, -1.0f, 1.0f)), -kHighest, kHighest);
}

glm::mat3 OrbitCamera::axes() const {
  const float level = std::cos(elevation_);
  const glm::vec3 backwards(level * std::sin(azimuth_), std::sin(elevation_),
                            level * std::cos(azimuth_));
  const glm::vec3 right(std::cos(azimuth_), 0.0f, -std::sin(azimuth_));
  return {right, glm::cross(backwards, right), backwards};
}

/// Half the view's height at the distance of the target, in world units.
float OrbitCamera::halfHeight() const {
  return start_.perspective ? distance_ * std::tan(start_.verticalFieldOfView / 2)
                            : start_.halfHeight;
}

void OrbitCamera::turn(glm::vec2 drag) {
  moved_ = true;
  azimuth_ = std::remainder(azimuth_ - kPi * drag.x, 2.0f * kPi);
  elevation_ = std::clamp(elevation_ + kPi * drag.y, -kHighest, kHighest);
}

void OrbitCamera::pan(glm::vec2 drag) {
  moved_ = true;
  const glm::mat3 frame = axes();
  target_ += glm::dvec3(2.0f * halfHeight() * (frame[1] * drag.y - frame[0] * drag.x));
}

void OrbitCamera::zoom(float steps) {
  moved_ = true;
  const float factor = std::pow(kZoomStep, -steps);
  if (start_.perspective)
    distance_ = std::clamp(distance_ * factor, leastDistance_, mostDistance_);
  else
    start_.halfHeight = std::clamp(start_.halfHeight * factor, leastDistance_, mostDistance_);
}

Camera OrbitCamera::camera() const {
  if (!moved_)
    return start_;
  Camera camera = start_;
  const glm::mat3 frame = axes();
  camera.worldFromCamera =
      glm::dmat4(glm::dvec4(frame[0], 0), glm::dvec4(frame[1], 0), glm::dvec4(frame[2], 0),
                 glm::dvec4(target_ + glm::dvec3(frame[2] * distance_), 1));
  if (camera.perspective)
    camera.near = std::min(start_.near, kNearShare * distance_);
  return camera;
}

} // namespace lichen::renderer
