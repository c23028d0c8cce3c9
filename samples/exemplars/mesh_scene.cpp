// SPDX-License-Identifier: MIT
// Vertex arrays -> accessors and bufferViews of one buffer; see mesh_scene.h.
#include "mesh_scene.h"

#include <lichen/gltf_files.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace lichen::exemplars {
namespace {

using nlohmann::ordered_json;

/// Appends data to the buffer, with a bufferView and an accessor for each array.
class Accessors {
public:
  explicit Accessors(ordered_json& json) : json_(json) {}

  /// Returns the accessor's index.
  template <std::size_t kComponents>
  std::size_t addVertices(const std::vector<std::array<float, kComponents>>& values) {
    constexpr int kFloat = 5126, kVertices = 34962;
    return add(std::as_bytes(std::span(values)), kVertices,
               {{"componentType", kFloat},
                {"count", values.size()},
                {"type", "VEC" + std::to_string(kComponents)}});
  }
  /// Adds white vertex colours with these alphas.
  std::size_t addColors(const std::vector<float>& alphas) {
    constexpr int kUnsignedByte = 5121, kVertices = 34962;
    constexpr std::uint8_t kOne = 255;
    std::vector<std::array<std::uint8_t, 4>> colors;
    for (const float alpha : alphas)
      colors.push_back({kOne, kOne, kOne, std::uint8_t(std::lround(alpha * float(kOne)))});
    return add(std::as_bytes(std::span(colors)), kVertices,
               {{"componentType", kUnsignedByte},
                {"normalized", true},
                {"count", alphas.size()},
                {"type", "VEC4"}});
  }
  std::size_t addIndices(const std::vector<std::uint32_t>& values) {
    constexpr int kUnsignedInt = 5125, kIndices = 34963;
    return add(std::as_bytes(std::span(values)), kIndices,
               {{"componentType", kUnsignedInt}, {"count", values.size()}, {"type", "SCALAR"}});
  }
  [[nodiscard]] const std::vector<std::byte>& binary() const { return binary_; }

private:
  std::size_t add(std::span<const std::byte> bytes, int target, const ordered_json& accessor) {
    const std::size_t index = json_["accessors"].size();
    json_["bufferViews"].push_back({{"buffer", 0},
                                    {"byteOffset", binary_.size()},
                                    {"byteLength", bytes.size()},
                                    {"target", target}});
    json_["accessors"].push_back(accessor);
    json_["accessors"].back()["bufferView"] = index;
    binary_.insert(binary_.end(), bytes.begin(), bytes.end());
    return index;
  }

  ordered_json& json_;
  std::vector<std::byte> binary_;
};

void addCameras(std::span<const SceneCamera> cameras, ordered_json& json) {
  for (const SceneCamera& camera : cameras) {
    ordered_json node{{"camera", json["cameras"].size()}, {"translation", camera.translation}};
    if (camera.rotation)
      node["rotation"] = *camera.rotation;
    json["scenes"][0]["nodes"].push_back(json["nodes"].size());
    json["nodes"].push_back(std::move(node));
    json["cameras"].push_back({{"name", camera.name},
                               {"type", "perspective"},
                               {"perspective", {{"yfov", 0.6}, {"znear", 0.1}}}});
  }
}

} // namespace

std::vector<std::byte> meshSceneGlb(const SceneMesh& mesh, std::span<const SceneCamera> cameras) {
  ordered_json json{{"asset", {{"version", "2.0"}, {"generator", "lichen-exemplars"}}},
                    {"scene", 0}};
  json["scenes"][0]["nodes"].push_back(0);
  json["nodes"].push_back({{"name", mesh.name}, {"mesh", 0}});
  addCameras(cameras, json);
  Accessors accessors(json);
  ordered_json attributes{{"POSITION", accessors.addVertices(mesh.positions)}};
  std::array<float, 3> least = mesh.positions.front(), most = least;
  for (const std::array<float, 3>& p : mesh.positions)
    for (std::size_t k = 0; k < 3; ++k) {
      least[k] = std::min(least[k], p[k]);
      most[k] = std::max(most[k], p[k]);
    }
  json["accessors"][0]["min"] = least;
  json["accessors"][0]["max"] = most;
  if (!mesh.normals.empty())
    attributes["NORMAL"] = accessors.addVertices(mesh.normals);
  if (!mesh.texCoords.empty())
    attributes["TEXCOORD_0"] = accessors.addVertices(mesh.texCoords);
  if (!mesh.alphas.empty())
    attributes["COLOR_0"] = accessors.addColors(mesh.alphas);
  json["meshes"][0]["name"] = mesh.name;
  const auto addPart = [&](const std::string& material, const std::vector<std::uint32_t>& triangles,
                           bool isBlended) {
    const std::size_t indices = accessors.addIndices(triangles);
    // read first: adding members below may move others
    const std::size_t index = json["materials"].size();
    json["meshes"][0]["primitives"].push_back(
        {{"attributes", attributes}, {"indices", indices}, {"material", index}});
    json["materials"].push_back(
        {{"name", material},
         {"pbrMetallicRoughness", {{"metallicFactor", 0.0}, {"roughnessFactor", 0.9}}},
         {"doubleSided", mesh.isDoubleSided}});
    if (isBlended)
      json["materials"].back()["alphaMode"] = "BLEND";
  };
  addPart(mesh.name, mesh.triangles, false);
  for (const ScenePart& part : mesh.otherParts)
    addPart(part.material, part.triangles, part.isBlended);
  json["buffers"][0]["byteLength"] = accessors.binary().size();
  return frameGlb(json.dump(), accessors.binary());
}

} // namespace lichen::exemplars
