// SPDX-License-Identifier: MIT
// Boxes around instances -> the subject's sphere; projections with a reversed depth, in which
// floats are as precise far away as near [Reed 2015, Depth Precision Visualized].
#include "framing.h"

#include "orthonormal_frame.h"
#include "printable.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace lichen::renderer {
namespace {

// A box is a ground when one side is this much thinner than the others, and the whole this much
// larger than all that is no ground.
constexpr float kFlatness = 0.02f;
constexpr float kGroundToRest = 3.0f;
// The automatic camera: a portrait lens from slightly above and the side.
constexpr float kAutoFieldOfView = 0.6f;
constexpr glm::vec3 kAutoDirection{0.45f, 0.32f, 1.0f};
constexpr float kAutoMargin = 1.12f;

struct Box {
  glm::vec3 low{std::numeric_limits<float>::max()};
  glm::vec3 high{std::numeric_limits<float>::lowest()};
  void add(glm::vec3 p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  void add(const Box& box) {
    low = glm::min(low, box.low);
    high = glm::max(high, box.high);
  }
  [[nodiscard]] bool empty() const { return low.x > high.x; }
  [[nodiscard]] glm::vec3 size() const { return high - low; }
  [[nodiscard]] float longest() const { return std::max(size().x, std::max(size().y, size().z)); }
  [[nodiscard]] bool flat() const {
    return std::min(size().x, std::min(size().y, size().z)) < kFlatness * longest();
  }
};

Box boxOf(const Scene& scene, const Instance& instance) {
  Box box;
  for (const Vertex& vertex : scene.primitives[instance.primitive].vertices)
    box.add(glm::vec3(instance.worldFromObject * glm::vec4(vertex.position, 1.0f)));
  return box;
}

Camera autoCamera(const Sphere& subject, float aspect) {
  Camera camera;
  camera.name = "auto";
  camera.verticalFieldOfView = kAutoFieldOfView;
  const float halfAngle = std::atan(std::tan(kAutoFieldOfView / 2) * std::min(aspect, 1.0f));
  const float distance = kAutoMargin * subject.radius / std::sin(halfAngle);
  const glm::vec3 z = glm::normalize(kAutoDirection);
  const glm::vec3 x = glm::normalize(glm::cross(glm::vec3(0, 1, 0), z));
  const glm::vec3 eye = subject.center + z * distance;
  camera.worldFromCamera = glm::mat4(glm::vec4(x, 0), glm::vec4(glm::cross(z, x), 0),
                                     glm::vec4(z, 0), glm::vec4(eye, 1));
  constexpr float kNearShare = 0.02f;
  camera.near = kNearShare * (distance - subject.radius);
  return camera;
}

} // namespace

Result<Sphere> subjectOf(const Scene& scene) {
  std::vector<Box> boxes;
  Box solid;
  Box all;
  for (const Instance& instance : scene.instances) {
    boxes.push_back(boxOf(scene, instance));
    all.add(boxes.back());
    if (!boxes.back().flat())
      solid.add(boxes.back());
  }
  Box subject = solid;
  for (const Box& box : boxes)
    if (solid.empty() || (box.flat() && box.longest() <= kGroundToRest * solid.longest()))
      subject.add(box);
  const float extent = std::max(glm::length(all.low), glm::length(all.high));
  if (!(extent < kMaxSceneReach))
    return Error{
        ErrorKind::badInput,
        fmt::format("the scene reaches {:.3g} units from its origin; below {:.0e} is accepted",
                    extent, kMaxSceneReach)};
  constexpr float kLeastRadius = 1e-6f;
  return Sphere{(subject.low + subject.high) * 0.5f,
                std::max(glm::length(subject.size()) * 0.5f, kLeastRadius)};
}

glm::vec3 centerOf(const Scene& scene, const Instance& instance) {
  const Box box = boxOf(scene, instance);
  return (box.low + box.high) * 0.5f;
}

Result<Camera> chooseCamera(const Scene& scene, const Sphere& subject, const std::string& choice,
                            float aspect) {
  if (choice == "auto" || (choice.empty() && scene.cameras.empty()))
    return autoCamera(subject, aspect);
  if (choice.empty())
    return scene.cameras.front();
  std::vector<std::string> names{"auto"};
  for (const auto name : {&Camera::nodeName, &Camera::name}) // of a camera may be several nodes
    for (const Camera& camera : scene.cameras) {
      if (camera.*name == choice)
        return camera;
      if (const std::string shown = printable(camera.*name);
          !(camera.*name).empty() && std::find(names.begin(), names.end(), shown) == names.end())
        names.push_back(shown);
    }
  std::string list;
  for (const std::string& name : names)
    list += (list.empty() ? "" : ", ") + name;
  return Error{ErrorKind::usage, "--camera " + printable(choice) +
                                     ": no such camera in the scene; there are " + list};
}

glm::mat4 clipFromWorld(const Camera& camera, float aspect, glm::vec2 jitterClip) {
  glm::mat4 projection(0.0f);
  const float narrower =
      camera.aspectRatio > 0.0f ? std::max(camera.aspectRatio / aspect, 1.0f) : 1.0f;
  if (camera.perspective) {
    const float halfHeight = std::tan(camera.verticalFieldOfView / 2) * narrower;
    projection[0][0] = 1.0f / (halfHeight * aspect);
    projection[1][1] = -1.0f / halfHeight;
    projection[2] = glm::vec4(-jitterClip, 0.0f, -1.0f);
    projection[3][2] = camera.near; // far plane at infinity: depth = near / distance
  } else {
    const float halfHeight = camera.halfHeight * narrower;
    projection[0][0] = 1.0f / (halfHeight * aspect);
    projection[1][1] = -1.0f / halfHeight;
    projection[2][2] = 1.0f / (camera.far - camera.near);
    projection[3] = glm::vec4(jitterClip, camera.far / (camera.far - camera.near), 1.0f);
  }
  return projection * glm::inverse(camera.worldFromCamera);
}

glm::mat4 clipFromWorldAlong(glm::vec3 toward, const Sphere& subject) {
  const glm::mat3 frame = frameAlong(toward);
  const float scale = 1.0f / subject.radius;
  const glm::mat3 rows =
      glm::transpose(glm::mat3(frame[0] * scale, frame[1] * scale, frame[2] * (-0.5f * scale)));
  return glm::mat4(glm::vec4(rows[0], 0), glm::vec4(rows[1], 0), glm::vec4(rows[2], 0),
                   glm::vec4(rows * -subject.center + glm::vec3(0, 0, 0.5f), 1));
}

} // namespace lichen::renderer
