// SPDX-License-Identifier: MIT
// Scene bounds, the subject of the picture, and the camera that frames it.
#pragma once

#include "scene.h"

#include <glm/glm.hpp>

#include <string>

namespace lichen::renderer {

struct Sphere {
  glm::dvec3 center{0.0};
  float radius = 1.0f;
};

/// Bounding sphere of the scene's subject: all instances except flat ones that are several times
/// larger than the rest, such as a ground plane. Errors: badInput if the scene is so large that its
/// squared extent overflows a float.
[[nodiscard]] Result<Sphere> subjectOf(const Scene& scene);

/// Centre of the instance's bounding box, in the world.
[[nodiscard]] glm::dvec3 centerOf(const Scene& scene, const Instance& instance);

/// Distance from the camera to the nearest corner of the instance's bounding box, along the viewing
/// axis; negative behind the camera.
[[nodiscard]] double depthOf(const Scene& scene, const Instance& instance, const Camera& camera);

/// `choice` is "auto" (frame the subject), the name of a camera's node or of a camera, or empty
/// (the file's first camera, or auto if the file has none). `aspect` is width over height. Errors:
/// usage, listing the available names; badInput for a camera with a fault.
[[nodiscard]] Result<Camera> chooseCamera(const Scene& scene, const Sphere& subject,
                                          const std::string& choice, float aspect);

/// Position of the camera in the world.
[[nodiscard]] glm::dvec3 eyeOf(const Camera& camera);

/// Origin for rendering: all positions on the device are relative to it. It is near a perspective
/// camera; for an orthographic camera it is the point on the axis next to the subject's centre. The
/// origin moves in whole steps, so it rarely changes between frames and stays the world's origin
/// for a scene around it. Rounding within a step is far below a pixel.
[[nodiscard]] glm::dvec3 originNear(const Camera& camera, const glm::dvec3& subject);

/// Half the height of the view: at distance 1 for a perspective camera. `aspect` is width over
/// height.
[[nodiscard]] float halfHeightOf(const Camera& camera, float aspect);

/// From positions relative to `origin` to Vulkan's clip space (y down) with reversed depth: 1 at
/// the near plane, 0 at the far plane. A picture wider than the camera's aspect ratio shows more at
/// the sides, a narrower one more above and below. `jitterClip` shifts the picture, in clip units.
[[nodiscard]] glm::mat4 clipFromWorld(const Camera& camera, const glm::dvec3& origin, float aspect,
                                      glm::vec2 jitterClip);

/// How many pixels of a picture of this size a unit of length covers at clip w 1, at most: of a
/// perspective camera in a corner of the picture. At clip w it covers 1 / w as many.
[[nodiscard]] float pixelsPerUnit(const glm::mat4& clipFromWorld, glm::vec2 size);

/// From positions relative to `origin` to the clip space of parallel light from the unit vector
/// `toward` (toward the light). The cross-section is square; cross-section and depth enclose
/// `subject`. Depth 0 is nearest to the light.
[[nodiscard]] glm::mat4 clipFromWorldAlong(glm::vec3 toward, const Sphere& subject,
                                           const glm::dvec3& origin);

} // namespace lichen::renderer
