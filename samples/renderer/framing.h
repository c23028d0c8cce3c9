// SPDX-License-Identifier: MIT
// Where a scene is, what of it is its subject, and the camera that looks at it.
#pragma once

#include "scene.h"

#include <glm/glm.hpp>

#include <string>

namespace lichen::renderer {

struct Sphere {
  glm::dvec3 center{0.0};
  float radius = 1.0f;
};

/// A sphere around the instances that are the scene's subject: all of them, but for flat ones that
/// are several times larger than the rest, such as a ground. Errors: badInput when the scene is so
/// large that its square overflows a float.
[[nodiscard]] Result<Sphere> subjectOf(const Scene& scene);

/// The middle of the box around an instance, in the world.
[[nodiscard]] glm::dvec3 centerOf(const Scene& scene, const Instance& instance);

/// How far before a camera, along its axis, the box around an instance begins; below 0 behind it.
[[nodiscard]] double depthOf(const Scene& scene, const Instance& instance, const Camera& camera);

/// "auto", which shows the subject as large as it fits; the name of a camera's node or of a camera
/// of the file; or empty for the file's first camera, and auto without one. `aspect` is width over
/// height. Errors: usage, with the names there are; badInput for a camera with a fault.
[[nodiscard]] Result<Camera> chooseCamera(const Scene& scene, const Sphere& subject,
                                          const std::string& choice, float aspect);

/// Where a camera is in the world.
[[nodiscard]] glm::dvec3 eyeOf(const Camera& camera);

/// A place in the world for all that is drawn to be relative to: near a perspective camera; of an
/// orthographic one on its axis, where the subject's center is beside it. It follows the camera in
/// whole steps, so that little changes from frame to frame and a scene around the world's origin is
/// drawn relative to just that; what rounding over a step moves is far below a pixel.
[[nodiscard]] glm::dvec3 originNear(const Camera& camera, const glm::dvec3& subject);

/// Half the height of what is seen: of a perspective camera one unit before it. `aspect` is width
/// over height.
[[nodiscard]] float halfHeightOf(const Camera& camera, float aspect);

/// Places relative to `origin` to Vulkan's clip space (y down), depth reversed: 1 at the near plane
/// and 0 at the far one. A picture wider than the camera's own aspect ratio shows more at the
/// sides, a narrower one more above and below. `jitterClip` shifts the picture, in clip units.
[[nodiscard]] glm::mat4 clipFromWorld(const Camera& camera, const glm::dvec3& origin, float aspect,
                                      glm::vec2 jitterClip);

/// Places relative to `origin` to the clip space of parallel light from direction `toward` (unit,
/// toward the light), whose square cross-section and depth enclose `subject`; depth 0 is nearest to
/// the light.
[[nodiscard]] glm::mat4 clipFromWorldAlong(glm::vec3 toward, const Sphere& subject,
                                           const glm::dvec3& origin);

} // namespace lichen::renderer
