// SPDX-License-Identifier: MIT
// A primitive's accessors -> positions and a list of triangles; see gltf_scene.h.
// Source: glTF 2.0 specification, sections 3.7.2 and 5.24.
#include "accessor_reader.h"
#include "gltf_scene_state.h"

#include <numeric>

namespace lichen {
namespace {

using nlohmann::json;

constexpr const char* kDraco = "KHR_draco_mesh_compression";

bool hasDraco(const json& primitive) {
  const auto extensions = primitive.find("extensions");
  return extensions != primitive.end() && extensions->is_object() && extensions->contains(kDraco);
}

/// The reason why a primitive's triangles cannot be read, or nothing.
std::optional<std::string> unreadable(const json& primitive) {
  const std::uint64_t mode = primitive.value("mode", kTriangles);
  if (mode < kTriangles || mode > kTriangleFan)
    return "mode " + std::to_string(mode) + ", points or lines; expected triangles";
  if (hasDraco(primitive))
    return std::string("is compressed with ") + kDraco +
           "; export the vertices without compression";
  if (!primitive["attributes"].contains("POSITION"))
    return "has no POSITION";
  return std::nullopt;
}

std::string countMismatch(std::size_t count, const char* what, std::size_t positions) {
  return std::to_string(count) + " " + what + " for " + std::to_string(positions) + " positions";
}

/// Reads a primitive; `triangles` holds the indices as stored. Records errors, after which the
/// result is incomplete.
PrimitiveGeometry readGeometry(GltfFile& file, const json& primitive, FindingList& findings) {
  PrimitiveGeometry geometry;
  const json& attributes = primitive["attributes"];
  const auto vectors = [&](const char* name) {
    auto values = readVectors<3>(file, attributes[name].get<std::size_t>(), findings);
    return values ? std::move(*values) : std::vector<std::array<float, 3>>();
  };
  geometry.positions = vectors("POSITION");
  if (attributes.contains("NORMAL"))
    geometry.normals = vectors("NORMAL");
  if (findings.errorCount() > 0)
    return geometry;
  if (!geometry.normals.empty() && geometry.normals.size() != geometry.positions.size())
    findings.error("accessor", "",
                   countMismatch(geometry.normals.size(), "normals", geometry.positions.size()));
  if (primitive.contains("indices")) {
    auto values = readIndices(file, primitive["indices"].get<std::size_t>(),
                              geometry.positions.size(), findings);
    if (values)
      geometry.triangles = std::move(*values);
  } else {
    geometry.triangles.resize(geometry.positions.size());
    std::iota(geometry.triangles.begin(), geometry.triangles.end(), 0u);
  }
  return geometry;
}

/// Checks the vertices of a scene's primitives, each accessor once. Records errors.
class VertexCheck {
public:
  VertexCheck(GltfFile& file, SoundAccessors& sound, FindingList& findings)
      : file_(file), sound_(sound), findings_(findings) {}

  void run(const json& primitive) {
    const json& attributes = primitive["attributes"];
    const std::optional<std::size_t> positions = count<3>(attributes["POSITION"]);
    if (!positions)
      return;
    if (attributes.contains("NORMAL"))
      expectCount(count<3>(attributes["NORMAL"]), *positions, "normals", attributes["NORMAL"]);
    for (const auto& [name, accessor] : attributes.items())
      if (name.starts_with("TEXCOORD_"))
        expectCount(count<2>(accessor), *positions, "texture coordinates", accessor);
    if (primitive.contains("indices"))
      indices(primitive["indices"].get<std::size_t>(), *positions);
  }

private:
  /// The number of the accessor's vectors, or nothing if it is invalid.
  template <std::size_t kComponents>
  std::optional<std::size_t> count(const json& accessor) {
    const std::pair key{accessor.get<std::size_t>(), kComponents};
    if (const auto known = sound_.vectors.find(key); known != sound_.vectors.end())
      return known->second;
    const auto values = readVectors<kComponents>(file_, key.first, findings_);
    if (!values)
      return std::nullopt;
    return sound_.vectors[key] = values->size();
  }

  void expectCount(std::optional<std::size_t> count, std::size_t positions, const char* what,
                   const json& accessor) {
    if (count && *count != positions)
      findings_.error("accessor", "/accessors/" + accessor.dump(),
                      countMismatch(*count, what, positions));
  }

  void indices(std::size_t accessor, std::size_t limit) {
    const std::pair key{accessor, limit};
    if (!sound_.indices.contains(key) && readIndices(file_, accessor, limit, findings_))
      sound_.indices.insert(key);
  }

  GltfFile& file_;
  SoundAccessors& sound_; // grows with each valid accessor
  FindingList& findings_;
};

/// The name of the extension that compresses a primitive's accessors, or nothing.
std::optional<std::string> compressionOf(const GltfFile& file, const json& primitive) {
  if (hasDraco(primitive))
    return kDraco;
  const auto ofAccessor = [&](const json& index) -> std::optional<std::string> {
    const json& accessor = file.document()["accessors"][index.get<std::size_t>()];
    for (const char* place :
         {"/bufferView", "/sparse/indices/bufferView", "/sparse/values/bufferView"}) {
      const json::json_pointer view(place);
      if (!accessor.contains(view) || !accessor[view].is_number_unsigned())
        continue;
      if (auto name = file.compressionOf(accessor[view].get<std::size_t>()))
        return name;
    }
    return std::nullopt;
  };
  for (const json& accessor : primitive["attributes"])
    if (std::optional<std::string> name = ofAccessor(accessor))
      return name;
  return primitive.contains("indices") ? ofAccessor(primitive["indices"]) : std::nullopt;
}

/// Returns what `read` reads from a part of the scene, or the first fault that it records.
template <class Read>
auto readFrom(const GltfScene& scene, const std::string& title, const Read& read) {
  using Value = decltype(read(std::declval<FindingList&>()));
  return withinMemory([&] { return scene.path().string() + ": not enough memory to read a mesh"; },
                      [&]() -> Result<Value> {
                        FindingList findings;
                        Value value = read(findings);
                        if (const Finding* fault = findings.firstError())
                          return asError(*fault, scene.path().string() + ": " + title);
                        return value;
                      });
}

} // namespace

Result<PrimitiveGeometry> GltfScene::geometry(PrimitivePlace place) {
  const json& primitive = state_->primitive(place);
  return readFrom(*this, primitiveTitle(place), [&](FindingList& findings) {
    PrimitiveGeometry geometry;
    if (const auto fault = unreadable(primitive))
      findings.error("unreadable", "", *fault);
    else
      geometry = readGeometry(*state_->file, primitive, findings);
    if (findings.errorCount() == 0)
      geometry.triangles =
          asTriangleList(std::move(geometry.triangles), primitive.value("mode", kTriangles));
    return geometry;
  });
}

Result<std::optional<std::string>> GltfScene::checkVertices(PrimitivePlace place) {
  const json& primitive = state_->primitive(place);
  return readFrom(*this, primitiveTitle(place), [&](FindingList& findings) {
    std::optional<std::string> compression;
    if (const std::uint64_t mode = primitive.value("mode", kTriangles); mode > kTriangleFan)
      findings.error("mode", "",
                     "mode " + std::to_string(mode) + "; expected 0 to " +
                         std::to_string(kTriangleFan));
    else if (compression = compressionOf(*state_->file, primitive);
             !compression && primitive["attributes"].contains("POSITION")) // or nothing is drawn
      VertexCheck(*state_->file, state_->soundAccessors, findings).run(primitive);
    return compression;
  });
}

} // namespace lichen
