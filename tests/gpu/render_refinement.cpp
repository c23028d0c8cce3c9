// SPDX-License-Identifier: MIT
// Meshes for displacement: edges short enough for the view, no cracks, and directions that
// coincident vertices share.
#include "../unit/bundle_example.h"
#include "displacement.h"
#include "framing.h"
#include "loaded_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

using namespace lichen;
using namespace lichen::test;
using namespace lichen::renderer;

namespace {

constexpr std::uint32_t kPixels = 200;
constexpr float kDepth = 0.2f;

Scene heightScene(bool onBox) {
  BundleFile file = example::smallestTexton();
  if (onBox)
    file.bundle.materials[0]->mapping = Mapping::triplanar;
  GltfScene source(encodeGlb(file).value());
  if (onBox)
    source.addBox(0);
  else
    source.addBall(0);
  source.addCamera(4.0f, 0.6f);
  return loaded(source);
}

Scene refined(const Scene& scene, float spacing) {
  Result<Scene> result = displacedScene(scene, {kDepth, spacing}, {"", kPixels, kPixels});
  REQUIRE(result.ok());
  return std::move(result).value();
}

/// The longest edge in pixels, as if each lay across the view.
float longestEdge(const Scene& scene) {
  const Camera& camera = scene.cameras.front();
  const glm::vec2 size(kPixels);
  const float pixels = pixelsPerUnit(clipFromWorld(camera, eyeOf(camera), 1.0f, {}), size);
  float longest = 0.0f;
  const Primitive& mesh = scene.primitives.front();
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const glm::vec3 a = mesh.vertices[mesh.indices[i]].position;
    const glm::vec3 b = mesh.vertices[mesh.indices[i / 3 * 3 + (i + 1) % 3]].position;
    const float depth = 4.0f - std::max(a.z, b.z) - kDepth; // the camera looks along -z
    longest = std::max(longest, glm::length(a - b) * pixels / depth);
  }
  return longest;
}

auto ordered(const glm::vec3& p) { return std::tuple(p.x, p.y, p.z); }

} // namespace

TEST_CASE("a mesh in view is refined to the distance of vertices") {
  for (const bool onBox : {false, true}) {
    const Scene scene = heightScene(onBox);
    for (const float spacing : {kVertexSpacing, 5.0f}) {
      const float longest = longestEdge(refined(scene, spacing));
      CHECK(longest <= spacing * 1.0001f);
      CHECK(longest > 0.5f * spacing);
    }
  }
}

TEST_CASE("triangles of a refined mesh share whole edges, also at hard edges and texture borders") {
  for (const bool onBox : {false, true}) {
    const Primitive mesh = refined(heightScene(onBox), 3.0f).primitives.front();
    const auto at = [&](std::size_t i) { return ordered(mesh.vertices[mesh.indices[i]].position); };
    std::map<std::pair<decltype(at(0)), decltype(at(0))>, int> edges;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
      const auto from = at(i), to = at(i / 3 * 3 + (i + 1) % 3);
      if (from != to) // not at a pole
        edges[from < to ? std::pair(from, to) : std::pair(to, from)] += from < to ? 1 : -1;
    }
    CHECK(edges.size() > 1000);
    CHECK(
        std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; }));
  }
}

TEST_CASE("coincident vertices move alike, and by the mean height where the noise jumps") {
  for (const bool onBox : {false, true}) {
    const Primitive mesh = refined(heightScene(onBox), kVertexSpacing).primitives.front();
    REQUIRE(mesh.displacement.size() == mesh.vertices.size());
    std::map<decltype(ordered({})), std::size_t> first;
    std::size_t onBorder = 0;
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
      const auto [entry, isNew] = first.try_emplace(ordered(mesh.vertices[i].position), i);
      const VertexDisplacement& own = mesh.displacement[i];
      const VertexDisplacement& other = mesh.displacement[entry->second];
      CHECK(own.direction == other.direction);
      CHECK(own.weight == other.weight);
      CHECK(own.texCoordsPerUnit == other.texCoordsPerUnit);
      // Interpolated in triangles whose unit vectors are as far apart as a corner of the box and a
      // normal: their cosine is at least 1 / sqrt(3), and the middle's length sqrt((1 + 2 cos) /
      // 3).
      CHECK(glm::length(own.direction) > 0.847f);
      CHECK(glm::length(own.direction) < 1.0001f);
      onBorder += own.weight == 0.0f;
      const glm::vec3 p = mesh.vertices[i].position;
      const glm::vec3 side = glm::abs(p) / 0.7f; // of the box
      const int sides = int(side.x > 0.999f) + int(side.y > 0.999f) + int(side.z > 0.999f);
      const bool isBorder = onBox ? sides > 1 : std::abs(p.z) < 1e-6f && p.x > 0.0f;
      if (isBorder)
        CHECK(own.weight == 0.0f);
    }
    CHECK(onBorder > 8);
    CHECK(onBorder < mesh.vertices.size());
  }
}

TEST_CASE("the picture of a displaced scene has room for its surface") {
  Scene scene = heightScene(false);
  const Sphere still = subjectOf(scene).value();
  for (Material& material : scene.materials)
    material.displacement = kDepth;
  const Sphere moved = subjectOf(scene).value();
  CHECK(moved.radius >= still.radius + kDepth);
  const Camera camera = chooseCamera(scene, moved, "auto", 1.0f).value();
  const glm::mat4 clip = clipFromWorld(camera, glm::dvec3(0.0), 1.0f, {});
  for (const Vertex& vertex : scene.primitives.front().vertices) {
    const glm::vec4 p = clip * glm::vec4((1.0f + kDepth) * vertex.position, 1.0f);
    CHECK(std::max(std::abs(p.x), std::abs(p.y)) < p.w);
    CHECK(p.z < p.w);
  }
}

TEST_CASE("vertices are farther apart where a mesh would become too large, and a note says so") {
  const Scene scene = heightScene(false);
  Displacement displacement{kDepth, 0.2f};
  displacement.mostVertices = 10000;
  const Result<Scene> result = displacedScene(scene, displacement, {"", kPixels, kPixels});
  REQUIRE(result.ok());
  const Scene& limited = result.value();
  CHECK(limited.primitives.front().vertices.size() <=
        scene.primitives.front().vertices.size() + displacement.mostVertices);
  REQUIRE(limited.notes.size() == scene.notes.size() + 1);
  CHECK(limited.notes.back().find("10000") != std::string::npos);
}
