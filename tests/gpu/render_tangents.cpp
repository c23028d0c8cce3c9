// SPDX-License-Identifier: MIT
// Tangents that the renderer makes, on meshes whose tangents follow by hand from MikkTSpace's
// rules.
#include "tangents.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numeric>

using namespace lichen;
using renderer::Primitive;
using renderer::Vertex;

namespace {

/// In the plane z = 0, with the normal that makes a counter-clockwise triangle's front; v upwards.
Vertex corner(glm::vec2 position, glm::vec2 uv) {
  Vertex vertex;
  vertex.position = glm::vec3(position, 0.0f);
  vertex.normal = glm::vec3(0, 0, 1);
  vertex.texCoord0 = glm::vec2(uv.x, 1.0f - uv.y);
  return vertex;
}

Primitive mesh(std::vector<Vertex> vertices, std::vector<std::uint32_t> indices) {
  Primitive primitive;
  primitive.vertices = std::move(vertices);
  primitive.indices = std::move(indices);
  return primitive;
}

Primitive withTangents(Primitive primitive) {
  renderer::makeTangents(primitive, &Vertex::texCoord0);
  return primitive;
}

/// The same triangles, a vertex for each corner.
Primitive unindexed(const Primitive& primitive) {
  Primitive result;
  for (const std::uint32_t index : primitive.indices)
    result.vertices.push_back(primitive.vertices[index]);
  result.indices.resize(primitive.indices.size());
  std::iota(result.indices.begin(), result.indices.end(), 0u);
  return result;
}

glm::vec4 tangentAt(const Primitive& primitive, std::size_t corner) {
  return primitive.vertices[primitive.indices[corner]].tangent;
}

void checkNear(glm::vec4 tangent, glm::vec2 direction, float side) {
  const glm::vec2 unit = glm::normalize(direction);
  CHECK(tangent.x == Approx(unit.x).margin(1e-6));
  CHECK(tangent.y == Approx(unit.y).margin(1e-6));
  CHECK(tangent.z == 0.0f);
  CHECK(tangent.w == side);
}

/// A right angle and half of one at the origin. In the first triangle u runs along x. In the second
/// the corner (-1, 1) has (u, v) = (-1, 0), so that P_v = y and -P_u = (-1, 1): u runs along
/// (1, -1).
Primitive fanOfTwoAngles() {
  return mesh({corner({0, 0}, {0, 0}), corner({9, 0}, {9, 0}), corner({0, 1}, {0, 1}),
               corner({-1, 1}, {-1, 0})},
              {0, 1, 2, 0, 2, 3});
}

/// A square of an image and its mirror image beside it: they share the edge x = 1.
Primitive mirroredPair() {
  return mesh({corner({0, 0}, {0, 0}), corner({1, 0}, {1, 0}), corner({2, 0}, {0, 0}),
               corner({0, 1}, {0, 1}), corner({1, 1}, {1, 1}), corner({2, 1}, {0, 1})},
              {0, 1, 3, 1, 4, 3, 1, 2, 4, 2, 5, 4});
}

} // namespace

TEST_CASE("triangles count by their angle at the vertex, not by their size") {
  const Primitive fan = withTangents(fanOfTwoAngles());
  const glm::vec2 expected = 2.0f * glm::vec2(1, 0) + glm::normalize(glm::vec2(1, -1));
  checkNear(tangentAt(fan, 0), expected, 1.0f);
  checkNear(tangentAt(fan, 3), expected, 1.0f);
  checkNear(tangentAt(fan, 1), {1, 0}, 1.0f);
  checkNear(tangentAt(fan, 5), {1, -1}, 1.0f);
  CHECK(fan.vertices.size() == 4);
}

TEST_CASE("an image and its mirror image have each its own tangent where they meet") {
  const Primitive pair = withTangents(mirroredPair());
  REQUIRE(pair.indices.size() == 12);
  for (std::size_t k = 0; k < 6; ++k) {
    checkNear(tangentAt(pair, k), {1, 0}, 1.0f);
    checkNear(tangentAt(pair, 6 + k), {-1, 0}, -1.0f);
  }
  CHECK(pair.vertices.size() == 8); // two on the edge are there twice
  const Primitive before = mirroredPair();
  for (std::size_t k = 0; k < 12; ++k)
    CHECK(pair.vertices[pair.indices[k]].position == before.vertices[before.indices[k]].position);
}

TEST_CASE("tangents do not depend on how vertices are indexed") {
  for (const Primitive& shared : {fanOfTwoAngles(), mirroredPair()}) {
    const Primitive a = withTangents(shared);
    const Primitive b = withTangents(unindexed(shared));
    for (std::size_t k = 0; k < a.indices.size(); ++k)
      CHECK(tangentAt(a, k) == tangentAt(b, k));
    CHECK(b.vertices.size() == b.indices.size());
  }
}

TEST_CASE("triangles that share a vertex and no edge have each its own tangent there") {
  const Primitive bow =
      withTangents(mesh({corner({0, 0}, {0, 0}), corner({1, 0}, {1, 0}), corner({1, 1}, {1, 1}),
                         corner({-1, 0}, {0, -1}), corner({-1, -1}, {1, -1})},
                        {0, 1, 2, 0, 3, 4}));
  checkNear(tangentAt(bow, 0), {1, 0}, 1.0f);
  checkNear(tangentAt(bow, 3), {0, -1}, 1.0f); // (-1, 0) is -v, (-1, -1) is u - v
}

TEST_CASE("a triangle without texture takes the tangents beside it") {
  const Primitive strip =
      withTangents(mesh({corner({0, 0}, {0, 0}), corner({1, 0}, {1, 0}), corner({0, 1}, {0, 1}),
                         corner({1, 1}, {1, 0})}, // as at (1, 0)
                        {0, 1, 2, 1, 3, 2}));
  checkNear(tangentAt(strip, 3), {1, 0}, 1.0f);
  checkNear(tangentAt(strip, 5), {1, 0}, 1.0f);
}

TEST_CASE("tangents of meshes that have no right ones are unit vectors in their surface") {
  std::vector<std::uint32_t> book; // of a thousand pages on one spine, either way round
  for (std::uint32_t page = 0; page < 1000; ++page)
    if (page % 3 == 0)
      book.insert(book.end(), {1, 0, page % 4});
    else
      book.insert(book.end(), {0, 1, page % 4});
  const std::vector<Vertex> square{corner({0, 0}, {0, 0}), corner({1, 0}, {1, 0}),
                                   corner({0, 1}, {0, 1}), corner({1, 1}, {1, 1})};
  const std::vector<Vertex> untextured{corner({0, 0}, {0, 0}), corner({1, 0}, {0, 0}),
                                       corner({0, 1}, {0, 0}), corner({1, 1}, {0, 0})};
  for (const Primitive& odd : {mesh(square, book), mesh(untextured, {0, 1, 2, 2, 1, 3})}) {
    const Primitive result = withTangents(odd);
    REQUIRE(result.vertices.size() <= result.indices.size());
    for (std::size_t k = 0; k < result.indices.size(); ++k) {
      const glm::vec4 tangent = tangentAt(result, k);
      CHECK(glm::length(glm::vec3(tangent)) == Approx(1.0f));
      CHECK(tangent.z == 0.0f);
      CHECK(std::abs(tangent.w) == 1.0f);
    }
  }
}
