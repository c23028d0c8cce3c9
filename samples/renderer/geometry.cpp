// SPDX-License-Identifier: MIT
// Accessors -> vertices and triangles [glTF 2.0, sections 3.6.2 and 3.7.2].
#include "geometry.h"

#include "accessor.h"
#include "orthonormal_frame.h"
#include "tangents.h"
#include "thin_solids.h"
#include "unit_vector.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace lichen::renderer {
namespace {

constexpr glm::vec3 kUp{0.0f, 1.0f, 0.0f}; // default normal

bool isThin(int mode) { return mode >= TINYGLTF_MODE_POINTS && mode < TINYGLTF_MODE_TRIANGLES; }

bool isStripOrFan(int mode) {
  return mode == TINYGLTF_MODE_TRIANGLE_STRIP || mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

/// Converts strips and fans to a list; drops an incomplete last triangle of a list.
std::vector<std::uint32_t> asTriangleList(const std::vector<std::uint32_t>& indices, int mode) {
  if (!isStripOrFan(mode)) {
    const auto whole = std::ptrdiff_t(indices.size() - indices.size() % 3);
    return {indices.begin(), indices.begin() + whole};
  }
  std::vector<std::uint32_t> list;
  for (std::size_t i = 0; i + 2 < indices.size(); ++i) {
    if (mode == TINYGLTF_MODE_TRIANGLE_FAN)
      list.insert(list.end(), {indices[i + 1], indices[i + 2], indices[0]});
    else
      list.insert(list.end(), {indices[i], indices[i + 1 + i % 2], indices[i + 2 - i % 2]});
  }
  return list;
}

/// Converts points, lines, strips and loops to a list of segments; a point becomes a segment from a
/// vertex to itself.
std::vector<std::uint32_t> asSegmentList(const std::vector<std::uint32_t>& indices, int mode) {
  const bool arePoints = mode == TINYGLTF_MODE_POINTS;
  const std::size_t step = mode == TINYGLTF_MODE_LINE ? 2 : 1;
  std::vector<std::uint32_t> list;
  for (std::size_t i = 0; i + (arePoints ? 0 : 1) < indices.size(); i += step)
    list.insert(list.end(), {indices[i], indices[arePoints ? i : i + 1]});
  if (mode == TINYGLTF_MODE_LINE_LOOP && indices.size() > 2)
    list.insert(list.end(), {indices.back(), indices.front()});
  return list;
}

/// Triangle or segment indices of a primitive; without indices in the file they are 0, 1, 2, ...
Result<std::vector<std::uint32_t>> readElements(const tinygltf::Model& model,
                                                const tinygltf::Primitive& source,
                                                std::size_t vertexCount) {
  std::vector<std::uint32_t> indices;
  if (source.indices >= 0) {
    Result<std::vector<std::uint32_t>> stored = readIndices(model, source.indices, vertexCount);
    if (!stored)
      return stored.error();
    indices = std::move(stored).value();
  } else {
    indices.resize(vertexCount);
    std::iota(indices.begin(), indices.end(), 0u);
  }
  return isThin(source.mode) ? asSegmentList(indices, source.mode)
                             : asTriangleList(indices, source.mode);
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

/// Copies attribute `name` into the vertices with `assign(vertex, pointer to its components,
/// component count)`. Returns whether the attribute exists.
template <class Assign>
Result<bool> readAttribute(const tinygltf::Model& model, const tinygltf::Primitive& source,
                           const std::string& name, Primitive& target, Assign assign) {
  const auto found = source.attributes.find(name);
  if (found == source.attributes.end())
    return false;
  Result<std::vector<float>> values = readAccessor(model, found->second);
  if (!values)
    return values.error();
  const std::size_t components = values.value().size() / target.vertices.size();
  for (std::size_t i = 0; i < target.vertices.size(); ++i)
    assign(target.vertices[i], values.value().data() + i * components, components);
  return true;
}

/// Reads all attributes of the vertices. Returns whether they include normals.
Result<bool> readVertices(const tinygltf::Model& model, const tinygltf::Primitive& source,
                          const Material& material, Primitive& target) {
  const auto vec3 = [](const float* p) { return glm::vec3(p[0], p[1], p[2]); };
  const auto read = [&](const std::string& name, auto assign) {
    return readAttribute(model, source, name, target, assign);
  };
  const std::string mixColors =
      material.mixColorSet ? "COLOR_" + std::to_string(*material.mixColorSet) : std::string();
  const std::array<Result<bool>, 7> present{
      read("NORMAL",
           [&](Vertex& v, const float* p, std::size_t) { v.normal = normalizedOr(vec3(p), kUp); }),
      read("POSITION", [&](Vertex& v, const float* p, std::size_t) { v.position = vec3(p); }),
      read("TANGENT",
           [&](Vertex& v, const float* p, std::size_t) {
             v.tangent = glm::vec4(normalizedOr(vec3(p), frameAlong(v.normal)[0]),
                                   p[3] < 0.0f ? -1.0f : 1.0f);
           }),
      read("TEXCOORD_0",
           [](Vertex& v, const float* p, std::size_t) { v.texCoord0 = glm::vec2(p[0], p[1]); }),
      read("TEXCOORD_1",
           [](Vertex& v, const float* p, std::size_t) { v.texCoord1 = glm::vec2(p[0], p[1]); }),
      read("COLOR_0",
           [&](Vertex& v, const float* p, std::size_t components) {
             v.color = glm::vec4(vec3(p), components == 4 ? p[3] : 1.0f);
           }),
      read(mixColors,
           [&](Vertex& v, const float* p, std::size_t components) {
             const auto channel = std::size_t(material.mixChannel);
             v.mixWeight = channel < components ? p[channel] : 1.0f; // alpha defaults to 1
           }),
  };
  for (const Result<bool>& result : present)
    if (!result)
      return result.error();
  return present[0].value();
}

/// The texture coordinate set to generate tangents for, or nullopt if none are needed or the file's
/// own are usable. Tangents of a file belong to its normal texture and are meaningless without its
/// normals.
std::optional<int> generatedTangents(const tinygltf::Primitive& source, const Material& material) {
  const TextureSlot& texture = material.normalTexture;
  if (!material.noiseNormalTexCoord && !texture.image)
    return std::nullopt;
  const int texCoord = material.noiseNormalTexCoord.value_or(texture.texCoord);
  const bool inFile = source.attributes.count("NORMAL") != 0 &&
                      source.attributes.count("TANGENT") != 0 && texCoord == texture.texCoord;
  return inFile ? std::nullopt : std::optional<int>(texCoord);
}

} // namespace

std::size_t expandedSize(const tinygltf::Model& model, const tinygltf::Primitive& source,
                         const Material& material, const RestPose& pose) {
  const auto position = source.attributes.find("POSITION");
  if (position == source.attributes.end())
    return 0;
  const std::size_t own = model.accessors[std::size_t(position->second)].count;
  const std::size_t stored =
      source.indices >= 0 ? model.accessors[std::size_t(source.indices)].count : own;
  // Deformed vertices keep a copy of the original, because a noise in object space is placed by it.
  const std::size_t copies = deforms(pose) && material.hasNoise ? 2 : 1;
  const std::size_t vertices = own * (copies + restPosePasses(source, pose));
  if (isThin(source.mode))
    return vertices + stored * (copies * kThinSolidVertices + kThinSolidIndices);
  const std::size_t indices = isStripOrFan(source.mode) ? 3 * stored : stored;
  // Flat normals need one vertex per index, tangents at most as many.
  const bool splits =
      source.attributes.count("NORMAL") == 0 || generatedTangents(source, material).has_value();
  return vertices + indices + (splits ? copies * indices : 0);
}

Result<std::optional<Primitive>> readPrimitive(const tinygltf::Model& model,
                                               const tinygltf::Primitive& source,
                                               const Material& material, const RestPose& pose) {
  const auto position = source.attributes.find("POSITION");
  if (position == source.attributes.end())
    return std::optional<Primitive>();
  Primitive target;
  Vertex blank;
  blank.normal = kUp;
  target.vertices.assign(model.accessors[std::size_t(position->second)].count, blank);
  for (std::size_t i = 0; i < target.vertices.size(); ++i)
    target.vertices[i].stored = std::uint32_t(i);
  Result<std::vector<std::uint32_t>> elements = readElements(model, source, target.vertices.size());
  if (!elements)
    return elements.error();
  target.indices = std::move(elements).value();
  if (target.indices.empty())
    return std::optional<Primitive>();
  const Result<bool> hasNormals = readVertices(model, source, material, target);
  if (!hasNormals)
    return hasNormals.error();
  if (deforms(pose)) {
    if (material.hasNoise)
      target.undeformed = target.vertices;
    if (Result<void> posed = applyRestPose(model, source, pose, target); !posed)
      return posed.error();
  }
  if (const float reach = reachOf(target.vertices); reach >= kMaxSceneReach)
    return Error{ErrorKind::badInput,
                 fmt::format("/accessors/{}: a vertex is {:.3g} units from its mesh's origin; the "
                             "limit is {:.0e}",
                             position->second, reach, kMaxSceneReach)};
  if (isThin(source.mode))
    makeThinSolids(target);
  else if (!hasNormals.value())
    makeFlat(target);
  if (const std::optional<int> texCoord = generatedTangents(source, material))
    makeTangents(target, *texCoord == 0 ? &Vertex::texCoord0 : &Vertex::texCoord1);
  matchUndeformed(target, !isThin(source.mode) && !hasNormals.value());
  return std::optional<Primitive>(std::move(target));
}

} // namespace lichen::renderer
