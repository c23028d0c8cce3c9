// SPDX-License-Identifier: MIT
// Generated tangents, on meshes whose tangents follow by hand from MikkTSpace's rules.
#include "tangents.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <numeric>

using namespace lichen;
using renderer::Primitive;
using renderer::Vertex;

namespace {

/// A vertex in the plane z = 0 with the normal (0, 0, 1), the front of a counter-clockwise
/// triangle; v points up.
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

/// The same triangles with one vertex per corner.
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

/// A square with an image next to one with its mirror image; they share the edge x = 1.
Primitive mirroredPair() {
  return mesh({corner({0, 0}, {0, 0}), corner({1, 0}, {1, 0}), corner({2, 0}, {0, 0}),
               corner({0, 1}, {0, 1}), corner({1, 1}, {1, 1}), corner({2, 1}, {0, 1})},
              {0, 1, 3, 1, 4, 3, 1, 2, 4, 2, 5, 4});
}

/// Four uneven quads; those on the right have a mirrored part of the image.
Primitive unevenGrid() {
  Primitive grid;
  const std::array<float, 3> columns{0.0f, 0.5f, 0.125f};
  for (int k = 0; k < 9; ++k) {
    const int x = k % 3;
    const int y = k / 3;
    Vertex v;
    v.position = glm::vec3(float(x) + 0.25f * float(5 * k % 4),
                           float(y) + 0.125f * float(3 * k % 5), 0.5f * float(7 * k % 3));
    v.normal = glm::normalize(glm::vec3(float(k % 3 - 1), 0.5f * float(k % 2), 3.0f));
    v.texCoord0 = glm::vec2(columns[std::size_t(x)] + 0.0625f * float(k % 2),
                            0.5f * float(y) + 0.125f * float(2 * k % 3));
    grid.vertices.push_back(v);
  }
  for (const std::uint32_t a : {0u, 1u, 3u, 4u})
    grid.indices.insert(grid.indices.end(), {a, a + 1, a + 4, a, a + 4, a + 3});
  return grid;
}

/// Results of Mikkelsen's own code (npm's mikktspace 1.1.1) for its corners, with the sign flipped
/// because glTF's v is.
const std::vector<glm::vec4> kMikkTSpace{
    {0.840448f, -0.463856f, 0.280149f, -1}, {0.994572f, -0.102634f, 0.017106f, -1},
    {0.148033f, -0.988982f, 0.000000f, -1}, {0.840448f, -0.463856f, 0.280149f, -1},
    {0.148033f, -0.988982f, 0.000000f, -1}, {0.332403f, -0.906070f, 0.261812f, -1},
    {-0.995501f, 0.093461f, -0.015577f, 1}, {-0.948190f, 0.032251f, 0.316063f, 1},
    {-0.948020f, 0.114378f, 0.296944f, 1},  {-0.995501f, 0.093461f, -0.015577f, 1},
    {-0.948020f, 0.114378f, 0.296944f, 1},  {-0.998688f, -0.051215f, 0.000000f, 1},
    {0.332403f, -0.906070f, 0.261812f, -1}, {0.148033f, -0.988982f, 0.000000f, -1},
    {0.636306f, -0.760941f, 0.126823f, -1}, {0.332403f, -0.906070f, 0.261812f, -1},
    {0.636306f, -0.760941f, 0.126823f, -1}, {0.858558f, -0.425412f, 0.286186f, -1},
    {-0.998688f, -0.051215f, 0.000000f, 1}, {-0.948020f, 0.114378f, 0.296944f, 1},
    {-0.852080f, -0.439645f, 0.284027f, 1}, {-0.998688f, -0.051215f, 0.000000f, 1},
    {-0.852080f, -0.439645f, 0.284027f, 1}, {-0.655921f, -0.744559f, 0.124093f, 1},
};

} // namespace

TEST_CASE("tangents match MikkTSpace") {
  const Primitive grid = withTangents(unevenGrid());
  REQUIRE(grid.indices.size() == kMikkTSpace.size());
  for (std::size_t k = 0; k < kMikkTSpace.size(); ++k)
    for (int c = 0; c < 4; ++c)
      CHECK(tangentAt(grid, k)[c] == Approx(kMikkTSpace[k][c]).margin(2e-6)); // six digits
}

TEST_CASE("an image and its mirror image have separate tangents where they meet") {
  const Primitive pair = withTangents(mirroredPair());
  REQUIRE(pair.indices.size() == 12);
  for (std::size_t k = 0; k < 6; ++k) {
    checkNear(tangentAt(pair, k), {1, 0}, 1.0f);
    checkNear(tangentAt(pair, 6 + k), {-1, 0}, -1.0f);
  }
  CHECK(pair.vertices.size() == 8); // the two on the edge are duplicated
  const Primitive before = mirroredPair();
  for (std::size_t k = 0; k < 12; ++k)
    CHECK(pair.vertices[pair.indices[k]].position == before.vertices[before.indices[k]].position);
}

TEST_CASE("tangents do not depend on the indexing of vertices") {
  for (const Primitive& shared : {unevenGrid(), mirroredPair()}) {
    const Primitive a = withTangents(shared);
    const Primitive b = withTangents(unindexed(shared));
    for (std::size_t k = 0; k < a.indices.size(); ++k)
      CHECK(tangentAt(a, k) == tangentAt(b, k));
    CHECK(b.vertices.size() == b.indices.size());
  }
}

TEST_CASE("triangles that share a vertex but no edge have separate tangents there") {
  const Primitive bow =
      withTangents(mesh({corner({0, 0}, {0, 0}), corner({1, 0}, {1, 0}), corner({1, 1}, {1, 1}),
                         corner({-1, 0}, {0, -1}), corner({-1, -1}, {1, -1})},
                        {0, 1, 2, 0, 3, 4}));
  checkNear(tangentAt(bow, 0), {1, 0}, 1.0f);
  checkNear(tangentAt(bow, 3), {0, -1}, 1.0f); // (-1, 0) is -v, (-1, -1) is u - v
}

TEST_CASE("a triangle without texture area takes the tangents of its neighbours") {
  const Primitive strip =
      withTangents(mesh({corner({0, 0}, {0, 0}), corner({1, 0}, {1, 0}), corner({0, 1}, {0, 1}),
                         corner({1, 1}, {1, 0})}, // same as at (1, 0)
                        {0, 1, 2, 1, 3, 2}));
  checkNear(tangentAt(strip, 3), {1, 0}, 1.0f);
  checkNear(tangentAt(strip, 5), {1, 0}, 1.0f);
}

TEST_CASE("tangents of meshes without a valid solution are unit vectors in the surface") {
  std::vector<std::uint32_t> book; // a thousand pages that share one edge, with either winding
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
