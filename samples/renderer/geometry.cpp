// SPDX-License-Identifier: MIT
// Accessors -> vertices and triangles [glTF 2.0, sections 3.6.2 and 3.7.2].
#include "geometry.h"

#include "directions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lichen::renderer {
namespace {

constexpr glm::vec3 kUp{0.0f, 1.0f, 0.0f}; // default normal

/// Triangle indices of a primitive; without indices in the file they are 0, 1, 2, ...
std::vector<std::uint32_t> readTriangles(SceneFile& file, const SourcePrimitive& source) {
  std::vector<std::uint32_t> indices;
  if (const std::optional<Place> stored = source.place.find("indices")) {
    indices = file.indices(*stored, source.vertices);
  } else {
    indices.resize(source.vertices);
    std::iota(indices.begin(), indices.end(), 0u);
  }
  return asTriangleList(std::move(indices), source.mode);
}

/// The largest absolute coordinate.
float reachOf(const std::vector<Vertex>& vertices) {
  float reach = 0.0f;
  for (const Vertex& v : vertices)
    for (int axis = 0; axis < 3; ++axis)
      reach = std::max(reach, std::abs(v.position[axis]));
  return reach;
}

/// Gives each triangle its own vertices with its geometric normal.
void makeFlat(Primitive& primitive) {
  std::vector<Vertex> vertices;
  vertices.reserve(primitive.indices.size());
  for (const std::uint32_t i : primitive.indices)
    vertices.push_back(primitive.vertices[i]);
  for (std::size_t i = 0; i < vertices.size(); i += 3) {
    const glm::vec3 edge1 = vertices[i + 1].position - vertices[i].position;
    const glm::vec3 edge2 = vertices[i + 2].position - vertices[i].position;
    const glm::vec3 normal = normalizedOr(glm::cross(edge1, edge2), kUp);
    for (std::size_t k = 0; k < 3; ++k) {
      vertices[i + k].normal = normal;
      primitive.indices[i + k] = std::uint32_t(i + k);
    }
  }
  primitive.vertices = std::move(vertices);
}

/// Reads all attributes of the vertices. Returns whether they include normals.
bool readVertices(SceneFile& file, const SourcePrimitive& source, const Material& material,
                  std::vector<Vertex>& vertices) {
  /// Calls `assign(vertex, its components)`, unless the attribute is absent.
  const auto read = [&]<std::size_t kComponents>(const std::string& name, const auto& assign,
                                                 auto... types) {
    const std::optional<Place> found = source.attributes.find(name.c_str());
    if (!found)
      return false;
    const auto values = file.vectors<kComponents>(*found, vertices.size(), types...);
    for (std::size_t i = 0; i < vertices.size(); ++i)
      assign(vertices[i], values[i]);
    return true;
  };
  /// Colours have three components or four.
  const auto readColors = [&](const std::string& name, const auto& assign) {
    const std::optional<Place> found = source.attributes.find(name.c_str());
    const std::initializer_list<std::uint64_t> types = {kFloat, kUnsignedByte, kUnsignedShort};
    const auto withAlpha = [&](Vertex& v, const std::array<float, 3>& c) {
      assign(v, std::array{c[0], c[1], c[2], 1.0f});
    };
    if (found && file.typeOf(*found) == "VEC3")
      read.template operator()<3>(name, withAlpha, types);
    else
      read.template operator()<4>(name, assign, types);
  };
  read.template operator()<3>("POSITION", [](Vertex& v, const std::array<float, 3>& p) {
    v.position = glm::make_vec3(p.data());
  });
  const bool hasNormals =
      read.template operator()<3>("NORMAL", [](Vertex& v, const std::array<float, 3>& p) {
        v.normal = normalizedOr(glm::make_vec3(p.data()), kUp);
      });
  read.template operator()<4>("TANGENT", [](Vertex& v, const std::array<float, 4>& p) {
    v.tangent = glm::vec4(normalizedOr(glm::make_vec3(p.data()), frameAlong(v.normal)[0]),
                          p[3] < 0.0f ? -1.0f : 1.0f);
  });
  read.template operator()<2>("TEXCOORD_0", [](Vertex& v, const std::array<float, 2>& p) {
    v.texCoord0 = glm::make_vec2(p.data());
  });
  read.template operator()<2>("TEXCOORD_1", [](Vertex& v, const std::array<float, 2>& p) {
    v.texCoord1 = glm::make_vec2(p.data());
  });
  readColors("COLOR_0",
             [](Vertex& v, const std::array<float, 4>& c) { v.color = glm::make_vec4(c.data()); });
  if (material.mixColorSet)
    readColors("COLOR_" + std::to_string(*material.mixColorSet),
               [&](Vertex& v, const std::array<float, 4>& c) {
                 v.mixWeight = c[std::size_t(material.mixChannel)];
               });
  return hasNormals;
}

/// Whether the file's tangents are of use: they belong to its normal texture and are meaningless
/// without its normals. Without them the shader takes the directions of the texture coordinates.
bool hasUsableTangents(const SourcePrimitive& source, const Material& material) {
  const int texCoord = material.noiseNormalTexCoord.value_or(material.normalTexture.texCoord);
  return source.attributes.find("NORMAL") && texCoord == material.normalTexture.texCoord;
}

} // namespace

SourcePrimitive sourcePrimitive(const SceneFile& file, const Place& place) {
  SourcePrimitive source{place, place.member("attributes"),
                         place.oneOf("mode", {0, 1, 2, 3, 4, 5, 6}).value_or(kTriangles)};
  if (const std::optional<Place> position = source.attributes.find("POSITION"))
    source.vertices = file.countOf(*position);
  const std::optional<Place> indices = place.find("indices");
  source.stored = indices ? file.countOf(*indices) : source.vertices;
  return source;
}

std::size_t expandedSize(const SourcePrimitive& source) {
  if (source.vertices == 0 || source.mode < kTriangles)
    return 0;
  const std::size_t indices = source.mode == kTriangles ? source.stored : 3 * source.stored;
  // Flat normals need one vertex per index.
  return source.vertices + (source.attributes.find("NORMAL") ? 1 : 2) * indices;
}

std::optional<Primitive> readPrimitive(SceneFile& file, const SourcePrimitive& source,
                                       const Material& material) {
  if (source.vertices == 0 || source.mode < kTriangles)
    return std::nullopt;
  Primitive target;
  Vertex blank;
  blank.normal = kUp;
  target.vertices.assign(source.vertices, blank);
  target.indices = readTriangles(file, source);
  if (target.indices.empty())
    return std::nullopt;
  const bool hasNormals = readVertices(file, source, material, target.vertices);
  if (const float reach = reachOf(target.vertices); reach >= kMaxSceneReach)
    source.attributes.fail(
        fmt::format("a vertex is {:.3g} units from its mesh's origin; the limit is {:.0e}", reach,
                    kMaxSceneReach));
  if (!hasNormals)
    makeFlat(target);
  if (!material.noiseNeedsTangents && !hasUsableTangents(source, material))
    for (Vertex& vertex : target.vertices)
      vertex.tangent = glm::vec4(0.0f);
  return target;
}

} // namespace lichen::renderer
