// SPDX-License-Identifier: MIT
// Boxes around instances -> the subject's sphere; projections with a reversed depth, in which
// floats are as precise far away as near [Reed 2015, Depth Precision Visualized].
#include "framing.h"

#include "orthonormal_frame.h"
#include "printable.h"
#include "world_place.h"

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
// Of the near plane's distance, or half an orthographic picture's height: a float of half a step is
// rounded by 3e-5 of that distance at most, a thirtieth of a pixel of a picture 1000 pixels high
// there, and less of what is farther.
constexpr double kOriginStep = 1024.0;

struct Box {
  glm::dvec3 low{std::numeric_limits<double>::max()};
  glm::dvec3 high{std::numeric_limits<double>::lowest()};
  void add(const glm::dvec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  void add(const Box& box) {
    low = glm::min(low, box.low);
    high = glm::max(high, box.high);
  }
  [[nodiscard]] bool empty() const { return low.x > high.x; }
  [[nodiscard]] glm::vec3 size() const { return {high - low}; }
  [[nodiscard]] float longest() const { return std::max(size().x, std::max(size().y, size().z)); }
  [[nodiscard]] bool flat() const {
    return std::min(size().x, std::min(size().y, size().z)) < kFlatness * longest();
  }
};

Box boxOf(const Scene& scene, const Instance& instance) {
  Box box;
  for (const Vertex& vertex : scene.primitives[instance.primitive].vertices)
    box.add(glm::dvec3(instance.worldFromObject * glm::dvec4(vertex.position, 1.0)));
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
  const glm::dvec3 eye = subject.center + glm::dvec3(z * distance);
  camera.worldFromCamera = glm::dmat4(glm::dvec4(x, 0), glm::dvec4(glm::cross(z, x), 0),
                                      glm::dvec4(z, 0), glm::dvec4(eye, 1));
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
  const double extent = std::max(glm::length(all.low), glm::length(all.high));
  if (!(extent < double(kMaxSceneReach)))
    return Error{
        ErrorKind::badInput,
        fmt::format("the scene reaches {:.3g} units from its origin; below {:.0e} is accepted",
                    extent, kMaxSceneReach)};
  constexpr float kLeastRadius = 1e-6f;
  return Sphere{(subject.low + subject.high) * 0.5,
                std::max(glm::length(subject.size()) * 0.5f, kLeastRadius)};
}

glm::dvec3 centerOf(const Scene& scene, const Instance& instance) {
  const Box box = boxOf(scene, instance);
  return (box.low + box.high) * 0.5;
}

glm::dvec3 eyeOf(const Camera& camera) { return {camera.worldFromCamera[3]}; }

glm::dvec3 originNear(const Camera& camera) {
  const double nearest = double(camera.perspective ? camera.near : camera.halfHeight);
  const double step = std::exp2(std::ceil(std::log2(kOriginStep * nearest)));
  const glm::dvec3 origin = glm::round(eyeOf(camera) / step) * step;
  // Farther out there is nothing to be seen.
  return glm::clamp(origin, -double(kMaxSceneReach), double(kMaxSceneReach));
}

Result<Camera> chooseCamera(const Scene& scene, const Sphere& subject, const std::string& choice,
                            float aspect) {
  if (choice == "auto" || (choice.empty() && scene.cameras.empty()))
    return autoCamera(subject, aspect);
  const auto sound = [&](const Camera& camera) -> Result<Camera> {
    if (!camera.fault.empty())
      return Error{ErrorKind::badInput, scene.name + ": " + camera.fault};
    return camera;
  };
  if (choice.empty())
    return sound(scene.cameras.front());
  std::vector<std::string> names{"auto"};
  for (const auto name : {&Camera::nodeName, &Camera::name}) // of a camera may be several nodes
    for (const Camera& camera : scene.cameras) {
      if (camera.*name == choice)
        return sound(camera);
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

glm::mat4 clipFromWorld(const Camera& camera, const glm::dvec3& origin, float aspect,
                        glm::vec2 jitterClip) {
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
  return projection * glm::inverse(relativeTo(origin, camera.worldFromCamera));
}

glm::mat4 clipFromWorldAlong(glm::vec3 toward, const Sphere& subject, const glm::dvec3& origin) {
  const glm::mat3 frame = frameAlong(toward);
  const float scale = 1.0f / subject.radius;
  const glm::mat3 rows =
      glm::transpose(glm::mat3(frame[0] * scale, frame[1] * scale, frame[2] * (-0.5f * scale)));
  return glm::mat4(
      glm::vec4(rows[0], 0), glm::vec4(rows[1], 0), glm::vec4(rows[2], 0),
      glm::vec4(rows * -relativeTo(origin, subject.center) + glm::vec3(0, 0, 0.5f), 1));
}

} // namespace lichen::renderer
