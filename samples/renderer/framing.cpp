// SPDX-License-Identifier: MIT
// Bounding boxes of instances -> the subject's bounding sphere; projections with reversed depth, in
// which floats keep their precision far away [Reed 2015, Depth Precision Visualized].
#include "framing.h"

#include "directions.h"
#include "printable.h"
#include "relative_to.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace lichen::renderer {
namespace {

// A box is ground if one side is shorter than this share of the longest one, and the box is this
// many times larger than everything that is not flat.
constexpr float kFlatness = 0.02f;
constexpr float kGroundToRest = 3.0f;
// The automatic camera: a portrait lens, looking from slightly above and from the side.
constexpr float kAutoFieldOfView = 0.6f;
constexpr glm::vec3 kAutoDirection{0.45f, 0.32f, 1.0f};
constexpr double kAutoMargin = 1.12;  // picture size over subject size
constexpr float kLeastRadius = 1e-6f; // of the subject: a single point has no extent
// In near plane distances, or half heights of an orthographic view. Half a step as a float is
// rounded by at most 3e-5 near plane distances: a thirtieth of a pixel at the near plane for a
// picture 1000 pixels high, and less farther away.
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
  void grow(float by) {
    low -= double(by);
    high += double(by);
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

/// How far the instance's surface may leave its triangles.
float displacementOf(const Scene& scene, const Instance& instance) {
  return scene.materials[scene.primitives[instance.primitive].material].displacement;
}

std::array<glm::dvec3, 8> cornersOf(const Box& box) {
  std::array<glm::dvec3, 8> corners;
  for (std::size_t k = 0; k < corners.size(); ++k)
    corners[k] = {(k & 1) != 0 ? box.high.x : box.low.x, (k & 2) != 0 ? box.high.y : box.low.y,
                  (k & 4) != 0 ? box.high.z : box.low.z};
  return corners;
}

std::vector<Box> boxesOf(const Scene& scene) {
  std::vector<Box> boxes;
  for (const Instance& instance : scene.instances)
    boxes.push_back(boxOf(scene, instance));
  return boxes;
}

/// Indices of the boxes that belong to the scene's subject.
std::vector<std::size_t> subjectInstances(const std::vector<Box>& boxes) {
  Box solid;
  for (const Box& box : boxes)
    if (!box.flat())
      solid.add(box);
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (solid.empty() || !boxes[i].flat() || boxes[i].longest() <= kGroundToRest * solid.longest())
      chosen.push_back(i);
  return chosen;
}

/// Radius of a ball around the subject's centre that holds its surfaces.
double ballAround(const Scene& scene, const glm::dvec3& center) {
  double radius = 0.0;
  for (const std::size_t i : subjectInstances(boxesOf(scene))) {
    const Instance& instance = scene.instances[i];
    const double displacement = double(displacementOf(scene, instance));
    for (const Vertex& vertex : scene.primitives[instance.primitive].vertices) {
      const glm::dvec3 p(instance.worldFromObject * glm::dvec4(vertex.position, 1.0));
      radius = std::max(radius, glm::distance(p, center) + displacement);
    }
  }
  return radius;
}

/// Shows the whole ball around the subject.
Camera autoCamera(const Scene& scene, const Sphere& subject, float aspect) {
  const glm::dvec3 z = glm::normalize(glm::dvec3(kAutoDirection));
  const glm::dvec3 x = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), z));
  const double slope = std::tan(double(kAutoFieldOfView) / 2) * std::min(double(aspect), 1.0);
  const double radius = std::max(ballAround(scene, subject.center), double(kLeastRadius));
  const double distance = kAutoMargin * radius / std::sin(std::atan(slope));
  constexpr double kNearShare = 0.02;
  Camera camera;
  camera.name = "auto";
  camera.verticalFieldOfView = kAutoFieldOfView;
  camera.near = float(kNearShare * (distance - radius));
  camera.worldFromCamera = glm::dmat4(glm::dmat3(x, glm::cross(z, x), z));
  camera.worldFromCamera[3] = glm::dvec4(subject.center + z * distance, 1.0);
  return camera;
}

} // namespace

Result<Sphere> subjectOf(const Scene& scene) {
  const std::vector<Box> boxes = boxesOf(scene);
  Box all;
  for (const Box& box : boxes)
    all.add(box);
  Box subject;
  for (const std::size_t i : subjectInstances(boxes)) {
    Box box = boxes[i];
    box.grow(displacementOf(scene, scene.instances[i]));
    subject.add(box);
  }
  const double extent = std::max(glm::length(all.low), glm::length(all.high));
  if (!(extent < double(kMaxSceneReach)))
    return Error{ErrorKind::badInput,
                 fmt::format("the scene reaches {:.3g} units from its origin; the limit is {:.0e}",
                             extent, kMaxSceneReach)};
  return Sphere{(subject.low + subject.high) * 0.5,
                std::max(glm::length(subject.size()) * 0.5f, kLeastRadius)};
}

glm::dvec3 centerOf(const Scene& scene, const Instance& instance) {
  const Box box = boxOf(scene, instance);
  return (box.low + box.high) * 0.5;
}

double depthOf(const Scene& scene, const Instance& instance, const Camera& camera) {
  const auto forward = -glm::normalize(glm::dvec3(camera.worldFromCamera[2]));
  double least = std::numeric_limits<double>::max();
  Box box = boxOf(scene, instance);
  box.grow(displacementOf(scene, instance));
  for (const glm::dvec3& corner : cornersOf(box))
    least = std::min(least, glm::dot(corner - eyeOf(camera), forward));
  return least;
}

glm::dvec3 eyeOf(const Camera& camera) { return {camera.worldFromCamera[3]}; }

glm::dvec3 originNear(const Camera& camera, const glm::dvec3& subject) {
  const double nearest = double(camera.perspective ? camera.near : camera.halfHeight);
  const double step = std::exp2(std::ceil(std::log2(kOriginStep * nearest)));
  glm::dvec3 center = eyeOf(camera);
  if (!camera.perspective) { // precision matters everywhere along its axis
    const auto axis = glm::normalize(glm::dvec3(camera.worldFromCamera[2]));
    center += axis * glm::dot(subject - center, axis);
  }
  const glm::dvec3 origin = glm::round(center / step) * step;
  // The loader rejects anything farther away.
  return glm::clamp(origin, -double(kMaxSceneReach), double(kMaxSceneReach));
}

Result<Camera> chooseCamera(const Scene& scene, const Sphere& subject, const std::string& choice,
                            float aspect) {
  if (choice == "auto" || (choice.empty() && scene.cameras.empty()))
    return autoCamera(scene, subject, aspect);
  const auto checked = [&](const Camera& camera) -> Result<Camera> {
    if (!camera.fault.empty())
      return Error{ErrorKind::badInput, scene.name + ": " + camera.fault};
    return camera;
  };
  if (choice.empty())
    return checked(scene.cameras.front());
  std::vector<std::string> names{"auto"};
  for (const auto name : {&Camera::nodeName, &Camera::name}) // several nodes may share a camera
    for (const Camera& camera : scene.cameras) {
      if (camera.*name == choice)
        return checked(camera);
      if (const std::string printableName = printable(camera.*name);
          !(camera.*name).empty() &&
          std::find(names.begin(), names.end(), printableName) == names.end())
        names.push_back(printableName);
    }
  std::string list;
  for (const std::string& name : names)
    list += (list.empty() ? "" : ", ") + name;
  return Error{ErrorKind::usage, "--camera " + printable(choice) +
                                     ": the scene has no such camera; available: " + list};
}

float halfHeightOf(const Camera& camera, float aspect) {
  const float narrower =
      camera.aspectRatio > 0.0f ? std::max(camera.aspectRatio / aspect, 1.0f) : 1.0f;
  return (camera.perspective ? std::tan(camera.verticalFieldOfView / 2) : camera.halfHeight) *
         narrower;
}

glm::mat4 clipFromWorld(const Camera& camera, const glm::dvec3& origin, float aspect,
                        glm::vec2 jitterClip) {
  glm::mat4 projection(0.0f);
  const float halfHeight = halfHeightOf(camera, aspect);
  if (camera.perspective) {
    projection[0][0] = 1.0f / (halfHeight * aspect);
    projection[1][1] = -1.0f / halfHeight;
    projection[2] = glm::vec4(-jitterClip, 0.0f, -1.0f);
    projection[3][2] = camera.near; // far plane at infinity: depth = near / distance
  } else {
    projection[0][0] = 1.0f / (halfHeight * aspect);
    projection[1][1] = -1.0f / halfHeight;
    projection[2][2] = 1.0f / (camera.far - camera.near);
    projection[3] = glm::vec4(jitterClip, camera.far / (camera.far - camera.near), 1.0f);
  }
  // In doubles, because an orthographic camera may be far from the origin along its axis.
  glm::dmat4 pose = camera.worldFromCamera;
  pose[3] -= glm::dvec4(origin, 0.0);
  return glm::mat4(glm::dmat4(projection) * glm::inverse(pose));
}

float pixelsPerUnit(const glm::mat4& clipFromWorld, glm::vec2 size) {
  // At w = 1 the rows of the derivative of a pixel's position are size.x / 2 (row 0 - x row 3) and
  // size.y / 2 (row 1 - y row 3) for x, y in [-1, 1]; rows 0, 1 and 3 are orthogonal.
  const glm::mat4 rows = glm::transpose(clipFromWorld);
  const auto lengthOf = [&](int row) { return glm::length(glm::vec3(rows[row])); };
  const float middle = std::max(size.x * lengthOf(0), size.y * lengthOf(1)) / 2;
  return std::hypot(middle, lengthOf(3) * glm::length(size) / 2);
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
