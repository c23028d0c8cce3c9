// SPDX-License-Identifier: MIT
// Where a scene is, what of it is its subject, and the camera that looks at it.
#pragma once

#include "scene.h"

#include <glm/glm.hpp>

#include <string>

namespace lichen::renderer {

struct Sphere {
  glm::vec3 center{0.0f};
  float radius = 1.0f;
};

/// A sphere around the instances that are the scene's subject: all of them, but for flat ones that
/// are several times larger than the rest, such as a ground. Errors: badInput when the scene is so
/// large that its square overflows a float.
[[nodiscard]] Result<Sphere> subjectOf(const Scene& scene);

/// The middle of the box around an instance, in the world.
[[nodiscard]] glm::vec3 centerOf(const Scene& scene, const Instance& instance);

/// "auto", the name of a camera's node or of a camera of the file, or empty for the file's first
/// camera and auto without one. `aspect` is width over height. Errors: usage, with the names there
/// are.
[[nodiscard]] Result<Camera> chooseCamera(const Scene& scene, const Sphere& subject,
                                          const std::string& choice, float aspect);

/// World to Vulkan's clip space (y down), depth reversed: 1 at the near plane and 0 at the far one.
/// A picture wider than the camera's own aspect ratio shows more at the sides, a narrower one more
/// above and below. `jitterClip` shifts the picture, in clip units.
[[nodiscard]] glm::mat4 clipFromWorld(const Camera& camera, float aspect, glm::vec2 jitterClip);

/// World to clip space of parallel light from direction `toward` (unit, toward the light), whose
/// square cross-section and depth enclose `subject`; depth 0 is nearest to the light.
[[nodiscard]] glm::mat4 clipFromWorldAlong(glm::vec3 toward, const Sphere& subject);

} // namespace lichen::renderer
