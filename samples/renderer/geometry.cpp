// SPDX-License-Identifier: MIT
// Accessors -> vertices and triangles [glTF 2.0, sections 3.6.2 and 3.7.2].
#include "geometry.h"

#include "directions.h"
#include "tangents.h"
#include "thin_solids.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lichen::renderer {
namespace {

constexpr glm::vec3 kUp{0.0f, 1.0f, 0.0f}; // default normal

// [glTF 2.0, section 5.24]
constexpr std::uint64_t kPoints = 0, kLines = 1, kLineLoop = 2;

bool isThin(std::uint64_t mode) { return mode < kTriangles; }

/// Converts points, lines, strips and loops to a list of segments; a point becomes a segment from a
/// vertex to itself.
std::vector<std::uint32_t> asSegmentList(const std::vector<std::uint32_t>& indices,
                                         std::uint64_t mode) {
  const bool arePoints = mode == kPoints;
  const std::size_t step = mode == kLines ? 2 : 1;
  std::vector<std::uint32_t> list;
  for (std::size_t i = 0; i + (arePoints ? 0 : 1) < indices.size(); i += step)
    list.insert(list.end(), {indices[i], indices[arePoints ? i : i + 1]});
  if (mode == kLineLoop && indices.size() > 2)
    list.insert(list.end(), {indices.back(), indices.front()});
  return list;
}

/// Triangle or segment indices of a primitive; without indices in the file they are 0, 1, 2, ...
std::vector<std::uint32_t> readElements(SceneFile& file, const SourcePrimitive& source) {
  std::vector<std::uint32_t> indices;
  if (const std::optional<Place> stored = source.place.find("indices")) {
    indices = file.indices(*stored, source.vertices);
  } else {
    indices.resize(source.vertices);
    std::iota(indices.begin(), indices.end(), 0u);
  }
  return isThin(source.mode) ? asSegmentList(indices, source.mode)
                             : asTriangleList(std::move(indices), source.mode);
}

/// The largest absolute coordinate, including vertices without an index: tangents and thin solids
/// are computed for them as well.
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

/// Reorders the undeformed vertices, still in the file's order, to match the final vertices.
void matchUndeformed(Primitive& primitive, bool isFlat) {
  if (primitive.undeformed.empty())
    return;
  std::vector<Vertex> undeformed;
  undeformed.reserve(primitive.vertices.size());
  for (const Vertex& v : primitive.vertices)
    undeformed.push_back(primitive.undeformed[v.stored]);
  primitive.undeformed = std::move(undeformed);
  if (!isFlat)
    return;
  for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) -> Vertex& {
      return primitive.undeformed[primitive.indices[i + k]];
    };
    const glm::vec3 across =
        glm::cross(at(1).position - at(0).position, at(2).position - at(0).position);
    const glm::vec3 normal = normalizedOr(across, kUp);
    for (std::size_t k = 0; k < 3; ++k)
      at(k).normal = glm::length(at(k).normal) * normal;
  }
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

/// The texture coordinate set to generate tangents for, or nullopt if none are needed or the file's
/// own are usable. Tangents of a file belong to its normal texture and are meaningless without its
/// normals.
std::optional<int> generatedTangents(const SourcePrimitive& source, const Material& material) {
  const TextureSlot& texture = material.normalTexture;
  if (!material.noiseNormalTexCoord && !texture.image)
    return std::nullopt;
  const int texCoord = material.noiseNormalTexCoord.value_or(texture.texCoord);
  const bool inFile = source.attributes.find("NORMAL") && source.attributes.find("TANGENT") &&
                      texCoord == texture.texCoord;
  return inFile ? std::nullopt : std::optional<int>(texCoord);
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

std::size_t expandedSize(const SourcePrimitive& source, const Material& material,
                         const RestPose& pose) {
  if (source.vertices == 0)
    return 0;
  // Deformed vertices keep a copy of the original, because a noise in object space is placed by it.
  const std::size_t copies = deforms(pose) && material.hasNoise ? 2 : 1;
  const std::size_t vertices = source.vertices * (copies + restPosePasses(source, pose));
  if (isThin(source.mode))
    return vertices + source.stored * (copies * kThinSolidVertices + kThinSolidIndices);
  const std::size_t indices = source.mode == kTriangles ? source.stored : 3 * source.stored;
  // Flat normals need one vertex per index, tangents at most as many.
  const bool splits =
      !source.attributes.find("NORMAL") || generatedTangents(source, material).has_value();
  return vertices + indices + (splits ? copies * indices : 0);
}

std::optional<Primitive> readPrimitive(SceneFile& file, const SourcePrimitive& source,
                                       const Material& material, const RestPose& pose) {
  if (source.vertices == 0)
    return std::nullopt;
  Primitive target;
  Vertex blank;
  blank.normal = kUp;
  target.vertices.assign(source.vertices, blank);
  for (std::size_t i = 0; i < target.vertices.size(); ++i)
    target.vertices[i].stored = std::uint32_t(i);
  target.indices = readElements(file, source);
  if (target.indices.empty())
    return std::nullopt;
  const bool hasNormals = readVertices(file, source, material, target.vertices);
  if (deforms(pose)) {
    if (material.hasNoise)
      target.undeformed = target.vertices;
    applyRestPose(file, source, pose, target);
  }
  if (const float reach = reachOf(target.vertices); reach >= kMaxSceneReach)
    source.attributes.fail(
        fmt::format("a vertex is {:.3g} units from its mesh's origin; the limit is {:.0e}", reach,
                    kMaxSceneReach));
  if (isThin(source.mode))
    makeThinSolids(target);
  else if (!hasNormals)
    makeFlat(target);
  if (const std::optional<int> texCoord = generatedTangents(source, material))
    makeTangents(target, *texCoord == 0 ? &Vertex::texCoord0 : &Vertex::texCoord1);
  matchUndeformed(target, !isThin(source.mode) && !hasNormals);
  return target;
}

} // namespace lichen::renderer
