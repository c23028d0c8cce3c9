// SPDX-License-Identifier: MIT
// Scene, camera -> a mesh with vertices as close as displacement needs them, and how each moves.
#include "displacement.h"

#include "directions.h"
#include "framing.h"
#include "refinement.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace lichen::renderer {
namespace {

// Directions that differ by less than 0.8 degrees are the same but for rounding.
constexpr float kSameDirection = 0.9999f;

bool sameDirection(const glm::vec3& a, const glm::vec3& b) {
  return glm::dot(a, b) >= kSameDirection * glm::length(a) * glm::length(b);
}

PixelView pixelViewOf(const Camera& camera, const DisplacementView& view) {
  PixelView result;
  const glm::vec2 size(view.width, view.height);
  result.eye = eyeOf(camera);
  result.clipFromEye = clipFromWorld(camera, result.eye, size.x / size.y, glm::vec2(0.0f));
  result.pixelsPerUnit = pixelsPerUnit(result.clipFromEye, size);
  result.nearest = camera.perspective ? camera.near : 0.0f;
  return result;
}

/// Calls `visit` with the indices of each group of vertices that have the same `key`, a vec3.
template <class Key, class Visit>
void forEachGroup(std::size_t count, const Key& key, const Visit& visit) {
  std::vector<std::pair<glm::vec3, std::uint32_t>> order;
  order.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i)
    order.emplace_back(key(i), i);
  const auto less = [](const auto& a, const auto& b) {
    return std::tie(a.first.x, a.first.y, a.first.z, a.second) <
           std::tie(b.first.x, b.first.y, b.first.z, b.second);
  };
  std::sort(order.begin(), order.end(), less);
  std::vector<std::uint32_t> group;
  for (std::size_t i = 0; i < count; ++i) {
    group.push_back(order[i].second);
    if (i + 1 < count && order[i + 1].first == order[i].first)
      continue;
    visit(std::as_const(group));
    group.clear();
  }
}

/// Makes positions equal that differ by rounding: those in a cell of either of two grids, since the
/// first may separate a pair.
void weld(std::vector<Vertex>& vertices) {
  glm::vec3 reach(0.0f);
  for (const Vertex& vertex : vertices)
    reach = glm::max(reach, glm::abs(vertex.position));
  constexpr float kRounding = 1e-6f; // sixteen times a float's
  const float cell = kRounding * std::max(reach.x, std::max(reach.y, reach.z));
  if (cell == 0.0f)
    return;
  for (const float shift : {0.5f, 0.0f})
    forEachGroup(
        vertices.size(),
        [&](std::uint32_t i) { return glm::floor(vertices[i].position / cell + shift); },
        [&](const std::vector<std::uint32_t>& group) {
          for (const std::uint32_t i : group)
            vertices[i].position = vertices[group.front()].position;
        });
}

/// Sets how the vertices of a primitive move.
class VertexDirections {
public:
  VertexDirections(Primitive& primitive, const Material& material)
      : primitive_(primitive), material_(material),
        texCoord_(material.noiseTexCoord.value_or(0) == 0 ? &Vertex::texCoord0
                                                          : &Vertex::texCoord1) {}

  void set() {
    const std::size_t count = primitive_.vertices.size();
    primitive_.displacement.assign(count, {});
    if (material_.noiseTexCoord)
      sumAreas();
    forEachGroup(
        count, [&](std::uint32_t i) { return at(i); },
        [&](const std::vector<std::uint32_t>& group) { setCoincident(group); });
  }

private:
  struct Areas {
    float texCoords = 0.0f, space = 0.0f;
  };

  [[nodiscard]] const glm::vec3& at(std::uint32_t vertex) const {
    return primitive_.vertices[vertex].position;
  }

  void sumAreas() {
    areas_.assign(primitive_.vertices.size(), {});
    for (std::size_t i = 0; i < primitive_.indices.size(); i += 3) {
      const std::uint32_t* corner = &primitive_.indices[i];
      const auto uv = [&](int k) { return primitive_.vertices[corner[k]].*texCoord_; };
      const glm::vec2 u = uv(1) - uv(0), v = uv(2) - uv(0);
      const float texCoords = std::abs(u.x * v.y - u.y * v.x);
      const float space =
          glm::length(glm::cross(at(corner[1]) - at(corner[0]), at(corner[2]) - at(corner[0])));
      for (int k = 0; k < 3; ++k) {
        areas_[corner[k]].texCoords += texCoords;
        areas_[corner[k]].space += space;
      }
    }
  }

  /// Whether the noise has the same height at two coincident vertices.
  [[nodiscard]] bool sameHeight(const Vertex& a, const Vertex& b) const {
    if (material_.noiseTexCoord)
      return a.*texCoord_ == b.*texCoord_;
    return sameDirection(a.normal, b.normal) &&
           (!material_.noiseNeedsTangents ||
            sameDirection(glm::vec3(a.tangent), glm::vec3(b.tangent)));
  }

  void setCoincident(const std::vector<std::uint32_t>& vertices) {
    const Vertex& first = primitive_.vertices[vertices.front()];
    VertexDisplacement common;
    Areas areas;
    for (const std::uint32_t v : vertices) {
      const Vertex& vertex = primitive_.vertices[v];
      common.direction += normalizedOr(vertex.normal, glm::vec3(0.0f));
      if (!sameHeight(first, vertex))
        common.weight = 0.0f;
      if (!areas_.empty()) {
        areas.texCoords += areas_[v].texCoords;
        areas.space += areas_[v].space;
      }
    }
    common.direction = normalizedOr(common.direction, glm::vec3(0.0f));
    if (areas.space > 0.0f)
      common.texCoordsPerUnit = std::sqrt(areas.texCoords / areas.space);
    for (const std::uint32_t v : vertices)
      primitive_.displacement[v] = common;
  }

  Primitive& primitive_;
  const Material& material_;
  glm::vec2 Vertex::*texCoord_;
  std::vector<Areas> areas_; ///< of the triangles around a vertex
};

/// Replaces the primitives of `scene`, whose materials have their displacement. Returns false if
/// they would have too many vertices.
bool refinePrimitives(const Scene& source, const PixelView& all, float spacing, Scene& scene) {
  PixelView view = all;
  scene.primitives.clear();
  std::vector<std::optional<std::size_t>> unchanged(source.primitives.size());
  for (std::size_t i = 0; i < source.instances.size(); ++i) {
    const Instance& instance = source.instances[i];
    const Primitive& primitive = source.primitives[instance.primitive];
    const Material& material = scene.materials[primitive.material];
    std::optional<std::size_t>& copy = unchanged[instance.primitive];
    const bool displaces = material.displacement > 0.0f;
    if (displaces || !copy) {
      copy = scene.primitives.size();
      scene.primitives.push_back(primitive);
    }
    scene.instances[i].primitive = *copy;
    if (!displaces)
      continue;
    Primitive& own = scene.primitives.back();
    const auto refined = [&](float pixels) {
      return refine(own, instance.worldFromObject, material.displacement, view, pixels);
    };
    weld(own.vertices);
    if (!refined(kFadeSpacings * spacing))
      return false;
    VertexDirections(own, material).set();
    if (!refined(spacing))
      return false;
    const std::size_t added = own.vertices.size() - primitive.vertices.size();
    if (added > view.mostVertices)
      return false;
    view.mostVertices -= added;
  }
  return true;
}

} // namespace

Result<Scene> displacedScene(const Scene& scene, const Displacement& displacement,
                             const DisplacementView& view) {
  Scene result = scene;
  for (Material& material : result.materials)
    material.displacement = material.noiseHasHeight ? displacement.depth : 0.0f;
  if (std::none_of(scene.instances.begin(), scene.instances.end(), [&](const Instance& instance) {
        return scene.materials[scene.primitives[instance.primitive].material].noiseHasHeight;
      }))
    return Error{ErrorKind::badInput,
                 scene.name + ": no mesh has a noise with a height map, which displacement needs; "
                              "bake a folder that has a map named height or displacement"};
  const Result<Sphere> subject = subjectOf(result);
  if (!subject)
    return subject.error();
  const Result<Camera> camera =
      chooseCamera(result, subject.value(), view.camera, float(view.width) / float(view.height));
  if (!camera)
    return camera.error();
  PixelView pixels = pixelViewOf(camera.value(), view);
  pixels.mostVertices = displacement.mostVertices;
  float spacing = displacement.spacing;
  while (!refinePrimitives(scene, pixels, spacing, result))
    spacing *= 2.0f;
  if (spacing > displacement.spacing)
    result.notes.push_back(fmt::format(
        "displacement needs more than {} additional vertices; they are up to {:.1f} pixels apart "
        "instead of {:.1f}, and displaced outlines are as much less exact",
        displacement.mostVertices, spacing, displacement.spacing));
  return result;
}

} // namespace lichen::renderer
