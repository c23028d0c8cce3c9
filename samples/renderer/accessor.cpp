// SPDX-License-Identifier: MIT
// Strided and sparse elements of a buffer -> values [glTF 2.0, section 3.6.2].
#include "accessor.h"

#include "scene_validate.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace lichen::renderer {
namespace {

Error accessorError(int accessor, const std::string& what) {
  return Error{ErrorKind::badInput, "/accessors/" + std::to_string(accessor) + ": " + what};
}

Error indexError(int accessor, const char* what, std::size_t index, std::size_t limit) {
  return accessorError(accessor, what + std::to_string(index) + " is out of range; expected 0 to " +
                                     std::to_string(limit - 1));
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

/// Calls `visit(element, pointer to its bytes)` for each stored element: first the elements of the
/// bufferView, then the sparse ones that replace them.
template <class Visit>
Result<void> eachElement(const tinygltf::Model& model, int accessorIndex, std::size_t elementBytes,
                         Visit visit) {
  const tinygltf::Accessor& accessor = model.accessors[std::size_t(accessorIndex)];
  if (accessor.bufferView >= 0) {
    const std::size_t stated = model.bufferViews[std::size_t(accessor.bufferView)].byteStride;
    const std::size_t stride = stated != 0 ? stated : elementBytes;
    const unsigned char* bytes = viewBytes(model, accessor.bufferView) + accessor.byteOffset;
    for (std::size_t i = 0; i < accessor.count; ++i)
      visit(i, bytes + i * stride);
  }
  if (!accessor.sparse.isSparse)
    return {};
  const auto& sparse = accessor.sparse;
  const unsigned char* indices =
      viewBytes(model, sparse.indices.bufferView) + sparse.indices.byteOffset;
  const unsigned char* patch =
      viewBytes(model, sparse.values.bufferView) + sparse.values.byteOffset;
  const std::size_t indexSize = componentBytes(std::uint64_t(sparse.indices.componentType));
  for (std::size_t i = 0; i < std::size_t(sparse.count); ++i) {
    const std::uint32_t element = index(indices + i * indexSize, sparse.indices.componentType);
    if (element >= accessor.count)
      return indexError(accessorIndex, "sparse index ", element, accessor.count);
    visit(element, patch + i * elementBytes);
  }
  return {};
}

} // namespace

Result<std::vector<float>> readAccessor(const tinygltf::Model& model, int accessorIndex) {
  const tinygltf::Accessor& accessor = model.accessors[std::size_t(accessorIndex)];
  const auto components =
      std::size_t(tinygltf::GetNumComponentsInType(std::uint32_t(accessor.type)));
  const std::size_t size = componentBytes(std::uint64_t(accessor.componentType));
  std::vector<float> values(accessor.count * components, 0.0f);
  const Result<void> read = eachElement(
      model, accessorIndex, components * size, [&](std::size_t i, const unsigned char* bytes) {
        for (std::size_t c = 0; c < components; ++c)
          values[i * components + c] =
              component(bytes + c * size, accessor.componentType, accessor.normalized);
      });
  if (!read)
    return read.error();
  if (!std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); }))
    return accessorError(accessorIndex, "contains NaN or infinity; all values must be finite");
  return values;
}

Result<std::vector<std::uint32_t>> readIndices(const tinygltf::Model& model, int accessorIndex,
                                               std::size_t limit) {
  const tinygltf::Accessor& accessor = model.accessors[std::size_t(accessorIndex)];
  std::vector<std::uint32_t> indices(accessor.count, 0u);
  const Result<void> read =
      eachElement(model, accessorIndex, componentBytes(std::uint64_t(accessor.componentType)),
                  [&](std::size_t i, const unsigned char* bytes) {
                    indices[i] = index(bytes, accessor.componentType);
                  });
  if (!read)
    return read.error();
  for (const std::uint32_t i : indices)
    if (i >= limit)
      return indexError(accessorIndex, "index ", i, limit);
  return indices;
}

} // namespace lichen::renderer
