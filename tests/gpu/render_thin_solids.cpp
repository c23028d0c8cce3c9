// SPDX-License-Identifier: MIT
// Points and lines become closed solids with their front outside, around the original.
#include "loaded_scene.h"
#include "thin_solids.h"

#include <map>

using namespace lichen;
using namespace lichen::test;
using renderer::Primitive;
using renderer::Vertex;

namespace {

Primitive segments(const std::vector<glm::vec3>& positions, std::vector<std::uint32_t> indices) {
  Primitive primitive;
  for (const glm::vec3 position : positions) {
    Vertex vertex;
    vertex.position = position;
    vertex.color = glm::vec4(position, 1.0f);
    primitive.vertices.push_back(vertex);
  }
  primitive.indices = std::move(indices);
  renderer::makeThinSolids(primitive);
  return primitive;
}

/// The volume that triangles enclose, by Gauss's theorem; negative if their fronts face inside.
float volume(const Primitive& solid) {
  double sum = 0.0;
  for (std::size_t i = 0; i < solid.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) {
      return glm::dvec3(solid.vertices[solid.indices[i + k]].position);
    };
    sum += glm::dot(at(0), glm::cross(at(1), at(2))) / 6.0;
  }
  return float(sum);
}

/// Whether each edge occurs once in each direction.
bool isClosed(const Primitive& solid) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  for (std::size_t i = 0; i < solid.indices.size(); ++i) {
    const std::uint32_t from = solid.indices[i];
    const std::uint32_t to = solid.indices[i % 3 == 2 ? i - 2 : i + 1];
    ++uses[{from, to}];
    --uses[{to, from}];
  }
  return std::all_of(uses.begin(), uses.end(), [](const auto& use) { return use.second == 0; });
}

std::size_t solidsOf(int mode) {
  GltfScene scene = triangleScene();
  auto& primitive = scene.json["meshes"][0]["primitives"][0];
  primitive["attributes"]["POSITION"] = scene.addFloats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, 3);
  primitive["indices"] = scene.addIndices({0, 1, 2, 3, 0}, 1);
  primitive["mode"] = mode;
  const Primitive solids = loaded(scene).primitives.at(0);
  CHECK(solids.vertices.size() * renderer::kThinSolidIndices ==
        solids.indices.size() * renderer::kThinSolidVertices);
  return solids.indices.size() / renderer::kThinSolidIndices;
}

} // namespace

TEST_CASE("a line becomes a closed rod around it, with its front outside") {
  for (const glm::vec3 end : {glm::vec3(3, 0, 0), glm::vec3(0, -3, 0), glm::vec3(1, 2, -2)}) {
    const Primitive rod = segments({{0, 0, 0}, end}, {0, 1});
    CHECK(rod.vertices.size() == renderer::kThinSolidVertices);
    CHECK(rod.indices.size() == renderer::kThinSolidIndices);
    CHECK(isClosed(rod));
    // A square cross-section with diagonal 2 r along the line, and a pyramid of height r at each
    // end, where r is 0.004 of the diagonal of the line's bounding box.
    const float radius = 0.004f * 3.0f;
    CHECK(volume(rod) == Approx(2 * radius * radius * (3.0f + 2.0f * radius / 3.0f)).epsilon(1e-3));
    for (const Vertex& v : rod.vertices) {
      CHECK(glm::length(v.normal) == Approx(1.0f));
      const bool atEnd = glm::dot(v.position, end) > 4.5f; // the maximum is 9
      CHECK(glm::distance(v.position, atEnd ? end : glm::vec3(0.0f)) ==
            Approx(radius).epsilon(1e-3));
      CHECK(v.color == glm::vec4(atEnd ? end : glm::vec3(0.0f), 1.0f));
    }
  }
}

TEST_CASE("a point becomes an octahedron, even a single one") {
  for (const auto& indices : {std::vector<std::uint32_t>{0, 0}, std::vector<std::uint32_t>{1, 1}}) {
    const Primitive point = segments({{0, 0, 0}, {7, 7, 7}}, indices);
    CHECK(isClosed(point));
    const float radius = 0.004f; // a point without extent counts as one unit
    CHECK(volume(point) == Approx(4.0f / 3.0f * radius * radius * radius).epsilon(0.01));
  }
}

TEST_CASE("five indices give five points, two lines, five lines of a loop or four of a strip") {
  CHECK(solidsOf(0) == 5);
  CHECK(solidsOf(1) == 2);
  CHECK(solidsOf(2) == 5); // the last one has no length
  CHECK(solidsOf(3) == 4);
}
