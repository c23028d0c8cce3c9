// SPDX-License-Identifier: MIT
// A primitive's accessors -> positions and a list of triangles; see gltf_scene.h.
// Source: glTF 2.0 specification, sections 3.7.2 and 5.24.
#include "accessor_reader.h"
#include "gltf_scene_state.h"

#include <numeric>

namespace lichen {
namespace {

using nlohmann::json;

constexpr std::uint64_t kTriangles = 4, kTriangleFan = 6; // a strip is between

/// A strip's or fan's triangles are wound like its first. A list loses an incomplete last one.
std::vector<std::uint32_t> asTriangleList(std::vector<std::uint32_t> indices, std::uint64_t mode) {
  if (mode == kTriangles) {
    indices.resize(indices.size() - indices.size() % 3);
    return indices;
  }
  std::vector<std::uint32_t> list;
  for (std::size_t i = 0; i + 2 < indices.size(); ++i) {
    if (mode == kTriangleFan)
      list.insert(list.end(), {indices[i + 1], indices[i + 2], indices[0]});
    else
      list.insert(list.end(), {indices[i], indices[i + 1 + i % 2], indices[i + 2 - i % 2]});
  }
  return list;
}

/// What of a primitive says that its triangles cannot be read, or nothing.
std::optional<std::string> unreadable(const json& primitive) {
  constexpr const char* kDraco = "KHR_draco_mesh_compression";
  const std::uint64_t mode = primitive.value("mode", kTriangles);
  if (mode < kTriangles || mode > kTriangleFan)
    return "mode " + std::to_string(mode) + ", points or lines; triangles are accepted";
  const auto extensions = primitive.find("extensions");
  if (extensions != primitive.end() && extensions->is_object() && extensions->contains(kDraco))
    return std::string("is compressed with ") + kDraco +
           "; vertices that are not compressed are accepted";
  if (!primitive["attributes"].contains("POSITION"))
    return "has no POSITION";
  return std::nullopt;
}

/// Errors are recorded; the result is then incomplete.
PrimitiveGeometry readGeometry(GltfFile& file, const json& primitive, FindingList& findings) {
  PrimitiveGeometry geometry;
  const json& attributes = primitive["attributes"];
  const auto vectors = [&](const char* name) {
    auto values = readVectors(file, attributes[name].get<std::size_t>(), findings);
    return values ? std::move(*values) : std::vector<std::array<float, 3>>();
  };
  geometry.positions = vectors("POSITION");
  if (attributes.contains("NORMAL"))
    geometry.normals = vectors("NORMAL");
  if (findings.errorCount() > 0)
    return geometry;
  if (!geometry.normals.empty() && geometry.normals.size() != geometry.positions.size())
    findings.error("accessor", "",
                   std::to_string(geometry.normals.size()) + " normals for " +
                       std::to_string(geometry.positions.size()) + " positions");
  std::vector<std::uint32_t> indices;
  if (primitive.contains("indices")) {
    auto values = readIndices(file, primitive["indices"].get<std::size_t>(),
                              geometry.positions.size(), findings);
    if (!values)
      return geometry;
    indices = std::move(*values);
  } else {
    indices.resize(geometry.positions.size());
    std::iota(indices.begin(), indices.end(), 0u);
  }
  geometry.triangles = asTriangleList(std::move(indices), primitive.value("mode", kTriangles));
  return geometry;
}

} // namespace

Result<PrimitiveGeometry> GltfScene::geometry(PrimitivePlace place) {
  const auto read = [&]() -> Result<PrimitiveGeometry> {
    const json& primitive = state_->primitive(place);
    const std::string title = state_->path.string() + ": " + primitiveTitle(place) + ": ";
    if (const auto fault = unreadable(primitive))
      return Error{ErrorKind::badInput, title + *fault};
    FindingList findings;
    PrimitiveGeometry geometry = readGeometry(*state_->file, primitive, findings);
    if (findings.errorCount() == 0)
      return geometry;
    const Finding& first = findings.all().front();
    return Error{first.code == "memory" ? ErrorKind::resources : ErrorKind::badInput,
                 title + first.pointer + (first.pointer.empty() ? "" : ": ") + first.message};
  };
  return withinMemory([&] { return state_->path.string() + ": not enough memory to read a mesh"; },
                      read);
}

} // namespace lichen
