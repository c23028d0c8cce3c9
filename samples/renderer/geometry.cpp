// SPDX-License-Identifier: MIT
// Accessors to vertices and triangles [glTF 2.0, sections 3.6.2 and 3.7.2].
#include "geometry.h"

#include "scene_validate.h"
#include "tangents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace lichen::renderer {
namespace {

Error accessorError(int accessor, const std::string& what) {
  return Error{ErrorKind::badInput, "/accessors/" + std::to_string(accessor) + ": " + what};
}

template <class T>
T load(const unsigned char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

template <class T>
float fromInteger(const unsigned char* bytes, bool normalized) {
  const auto value = float(load<T>(bytes));
  return normalized ? std::max(value / float(std::numeric_limits<T>::max()), -1.0f) : value;
}

float component(const unsigned char* bytes, int type, bool normalized) {
  switch (type) {
  case TINYGLTF_COMPONENT_TYPE_BYTE:
    return fromInteger<std::int8_t>(bytes, normalized);
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
    return fromInteger<std::uint8_t>(bytes, normalized);
  case TINYGLTF_COMPONENT_TYPE_SHORT:
    return fromInteger<std::int16_t>(bytes, normalized);
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
    return fromInteger<std::uint16_t>(bytes, normalized);
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    return fromInteger<std::uint32_t>(bytes, normalized);
  default:
    return load<float>(bytes);
  }
}

std::uint32_t index(const unsigned char* bytes, int type) {
  switch (type) {
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
    return *bytes;
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
    return load<std::uint16_t>(bytes);
  default:
    return load<std::uint32_t>(bytes);
  }
}

const unsigned char* viewBytes(const tinygltf::Model& model, int view) {
  const tinygltf::BufferView& v = model.bufferViews[std::size_t(view)];
  return model.buffers[std::size_t(v.buffer)].data.data() + v.byteOffset;
}

std::size_t elementStride(const tinygltf::Model& model, const tinygltf::Accessor& accessor,
                          std::size_t elementSize) {
  const std::size_t stride = model.bufferViews[std::size_t(accessor.bufferView)].byteStride;
  return stride != 0 ? stride : elementSize;
}

/// Indices of a primitive, or 0, 1, 2, ... without an index accessor.
Result<std::vector<std::uint32_t>> readIndices(const tinygltf::Model& model,
                                               const tinygltf::Primitive& primitive,
                                               std::size_t vertexCount) {
  std::vector<std::uint32_t> indices;
  if (primitive.indices < 0) {
    indices.resize(vertexCount);
    for (std::size_t i = 0; i < vertexCount; ++i)
      indices[i] = std::uint32_t(i);
    return indices;
  }
  const tinygltf::Accessor& accessor = model.accessors[std::size_t(primitive.indices)];
  if (accessor.bufferView < 0 || accessor.sparse.isSparse)
    return accessorError(primitive.indices, "indices without a bufferView, or sparse, are not "
                                            "accepted");
  const std::size_t size = componentBytes(std::uint64_t(accessor.componentType));
  const std::size_t stride = elementStride(model, accessor, size);
  const unsigned char* bytes = viewBytes(model, accessor.bufferView) + accessor.byteOffset;
  indices.resize(accessor.count);
  for (std::size_t i = 0; i < accessor.count; ++i) {
    indices[i] = index(bytes + i * stride, accessor.componentType);
    if (indices[i] >= vertexCount)
      return accessorError(primitive.indices, "index " + std::to_string(indices[i]) +
                                                  " is not accepted, 0 to " +
                                                  std::to_string(vertexCount - 1) + " is");
  }
  return indices;
}

bool isStripOrFan(int mode) {
  return mode == TINYGLTF_MODE_TRIANGLE_STRIP || mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

/// Strips and fans as a list; a list loses an incomplete last triangle.
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

glm::vec3 normalizedOr(glm::vec3 v, glm::vec3 fallback) {
  const float length = glm::length(v);
  return length > std::numeric_limits<float>::min() ? v / length : fallback;
}

/// Each triangle gets vertices of its own and its geometric normal.
void makeFlat(Primitive& primitive) {
  std::vector<Vertex> vertices;
  vertices.reserve(primitive.indices.size());
  for (const std::uint32_t i : primitive.indices)
    vertices.push_back(primitive.vertices[i]);
  for (std::size_t i = 0; i < vertices.size(); i += 3) {
    const glm::vec3 edge1 = vertices[i + 1].position - vertices[i].position;
    const glm::vec3 edge2 = vertices[i + 2].position - vertices[i].position;
    const glm::vec3 normal = normalizedOr(glm::cross(edge1, edge2), glm::vec3(0.0f, 1.0f, 0.0f));
    for (std::size_t k = 0; k < 3; ++k) {
      vertices[i + k].normal = normal;
      primitive.indices[i + k] = std::uint32_t(i + k);
    }
  }
  primitive.vertices = std::move(vertices);
}

/// Copies attribute `name` into the vertices by `assign(vertex, pointer to its components)`.
template <class Assign>
Result<bool> readAttribute(const tinygltf::Model& model, const tinygltf::Primitive& source,
                           const char* name, Primitive& target, Assign assign) {
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

/// The set of texture coordinates that tangents are made for, where the file's will not do: they
/// mean nothing without its normals, and belong to the normal texture.
std::optional<int> madeTangents(const tinygltf::Primitive& source, const Material& material) {
  const TextureSlot& texture = material.normalTexture;
  if (!material.noiseNormalTexCoord && !texture.image)
    return std::nullopt;
  const int texCoord = material.noiseNormalTexCoord.value_or(texture.texCoord);
  const bool inFile = source.attributes.count("NORMAL") != 0 &&
                      source.attributes.count("TANGENT") != 0 && texCoord == texture.texCoord;
  return inFile ? std::nullopt : std::optional<int>(texCoord);
}

} // namespace

Result<std::vector<float>> readAccessor(const tinygltf::Model& model, int accessorIndex) {
  const tinygltf::Accessor& accessor = model.accessors[std::size_t(accessorIndex)];
  const auto components =
      std::size_t(tinygltf::GetNumComponentsInType(std::uint32_t(accessor.type)));
  const std::size_t size = componentBytes(std::uint64_t(accessor.componentType));
  std::vector<float> values(accessor.count * components, 0.0f);
  const auto copyElement = [&](std::size_t element, const unsigned char* bytes) {
    for (std::size_t c = 0; c < components; ++c)
      values[element * components + c] =
          component(bytes + c * size, accessor.componentType, accessor.normalized);
  };
  if (accessor.bufferView >= 0) {
    const std::size_t stride = elementStride(model, accessor, components * size);
    const unsigned char* bytes = viewBytes(model, accessor.bufferView) + accessor.byteOffset;
    for (std::size_t i = 0; i < accessor.count; ++i)
      copyElement(i, bytes + i * stride);
  }
  if (accessor.sparse.isSparse) {
    const auto& sparse = accessor.sparse;
    const unsigned char* indices =
        viewBytes(model, sparse.indices.bufferView) + sparse.indices.byteOffset;
    const unsigned char* patch =
        viewBytes(model, sparse.values.bufferView) + sparse.values.byteOffset;
    const std::size_t indexSize = componentBytes(std::uint64_t(sparse.indices.componentType));
    for (std::size_t i = 0; i < std::size_t(sparse.count); ++i) {
      const std::uint32_t element = index(indices + i * indexSize, sparse.indices.componentType);
      if (element >= accessor.count)
        return accessorError(accessorIndex, "sparse index " + std::to_string(element) +
                                                " is not accepted, 0 to " +
                                                std::to_string(accessor.count - 1) + " is");
      copyElement(element, patch + i * components * size);
    }
  }
  if (!std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); }))
    return accessorError(accessorIndex, "holds NaN or infinite values; finite ones are accepted");
  return values;
}

std::size_t expandedSize(const tinygltf::Model& model, const tinygltf::Primitive& source,
                         const Material& material) {
  const auto position = source.attributes.find("POSITION");
  if (position == source.attributes.end())
    return 0;
  const std::size_t vertices = model.accessors[std::size_t(position->second)].count;
  const std::size_t stored =
      source.indices >= 0 ? model.accessors[std::size_t(source.indices)].count : vertices;
  const std::size_t indices = isStripOrFan(source.mode) ? 3 * stored : stored;
  // Flat normals take a vertex for each index, and tangents as many at most.
  const bool splits =
      source.attributes.count("NORMAL") == 0 || madeTangents(source, material).has_value();
  return vertices + indices + (splits ? indices : 0);
}

Result<std::optional<Primitive>> readPrimitive(const tinygltf::Model& model,
                                               const tinygltf::Primitive& source,
                                               const Material& material) {
  const auto position = source.attributes.find("POSITION");
  if (position == source.attributes.end() ||
      (source.mode >= TINYGLTF_MODE_POINTS && source.mode < TINYGLTF_MODE_TRIANGLES))
    return std::optional<Primitive>();
  Primitive target;
  target.vertices.resize(model.accessors[std::size_t(position->second)].count);
  Result<std::vector<std::uint32_t>> indices = readIndices(model, source, target.vertices.size());
  if (!indices)
    return indices.error();
  target.indices = asTriangleList(indices.value(), source.mode);
  if (target.indices.empty())
    return std::optional<Primitive>();

  const auto vec3 = [](const float* p) { return glm::vec3(p[0], p[1], p[2]); };
  const auto read = [&](const char* name, auto assign) {
    return readAttribute(model, source, name, target, assign);
  };
  std::array<Result<bool>, 6> present{
      read("POSITION", [&](Vertex& v, const float* p, std::size_t) { v.position = vec3(p); }),
      read("NORMAL",
           [&](Vertex& v, const float* p, std::size_t) {
             v.normal = normalizedOr(vec3(p), glm::vec3(0.0f, 1.0f, 0.0f));
           }),
      read("TANGENT",
           [&](Vertex& v, const float* p, std::size_t) {
             v.tangent = glm::vec4(normalizedOr(vec3(p), anyPerpendicular(v.normal)),
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
  };
  for (const Result<bool>& result : present)
    if (!result)
      return result.error();
  if (material.mixColorSet) {
    const std::string colors = "COLOR_" + std::to_string(*material.mixColorSet);
    const Result<bool> mixed =
        read(colors.c_str(), [&](Vertex& v, const float* p, std::size_t components) {
          const auto channel = std::size_t(material.mixChannel);
          v.mixWeight = channel < components ? p[channel] : 1.0f; // opaque without alpha
        });
    if (!mixed)
      return mixed.error();
  }
  if (!present[1].value())
    makeFlat(target);
  if (const std::optional<int> texCoord = madeTangents(source, material))
    makeTangents(target, *texCoord == 0 ? &Vertex::texCoord0 : &Vertex::texCoord1);
  return std::optional<Primitive>(std::move(target));
}

} // namespace lichen::renderer
