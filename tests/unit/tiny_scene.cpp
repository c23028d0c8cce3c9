// SPDX-License-Identifier: MIT
// Scenes and noises for tests; see tiny_scene.h.
#include "tiny_scene.h"

#include "bundle_example.h"

#include <lichen/gltf_files.h>

namespace lichen::example {

std::size_t TinyScene::addView(std::span<const std::byte> bytes, std::size_t stride) {
  binary.resize((binary.size() + 3) / 4 * 4);
  nlohmann::ordered_json view = {
      {"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes.size()}};
  if (stride != 0)
    view["byteStride"] = stride;
  json["bufferViews"].push_back(view);
  binary.insert(binary.end(), bytes.begin(), bytes.end());
  return json["bufferViews"].size() - 1;
}

std::size_t TinyScene::addFloats(const std::vector<float>& values, const char* type,
                                 std::size_t components) {
  constexpr int kFloat = 5126;
  return addAccessor(values, type, kFloat, components);
}

std::vector<std::byte> TinyScene::glb() const {
  nlohmann::ordered_json document = json;
  document["buffers"] = {{{"byteLength", binary.size()}}};
  return frameGlb(document.dump(), binary);
}

std::string TinyScene::gltf(const std::string& uri) const {
  nlohmann::ordered_json document = json;
  document["buffers"] = {{{"uri", uri}, {"byteLength", binary.size()}}};
  return document.dump(2);
}

TinyScene tableScene() {
  constexpr int kUnsignedShort = 5123;
  TinyScene scene;
  const std::size_t square = scene.addFloats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, "VEC3", 3);
  scene.json["accessors"][square]["min"] = {0, 0, 0};
  scene.json["accessors"][square]["max"] = {1, 1, 0};
  const std::size_t normals = scene.addFloats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 3);
  const std::size_t texCoords = scene.addFloats({0, 1, 1, 1, 1, 0, 0, 0}, "VEC2", 2);
  const std::size_t indices =
      scene.addAccessor(std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3}, "SCALAR", kUnsignedShort, 1);
  const std::size_t pyramid =
      scene.addFloats({1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1}, "VEC3", 3);
  scene.json["accessors"][pyramid]["min"] = {-1, -1, -1};
  scene.json["accessors"][pyramid]["max"] = {1, 1, 1};
  const std::size_t faces = scene.addAccessor(
      std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2}, "SCALAR", kUnsignedShort, 1);
  constexpr int kVertices = 34962, kIndices = 34963;
  for (const std::size_t accessor : {square, normals, texCoords, indices, pyramid, faces})
    scene.json["bufferViews"][accessor]["target"] =
        accessor == indices || accessor == faces ? kIndices : kVertices;
  scene.json["materials"] = {
      {{"name", "wood"}, {"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.25, 0.125, 1.0}}}}},
      {{"name", "glass"}, {"doubleSided", true}}};
  scene.json["meshes"] = {
      {{"name", "table"},
       {"primitives",
        {{{"attributes", {{"POSITION", square}, {"NORMAL", normals}, {"TEXCOORD_0", texCoords}}},
          {"indices", indices},
          {"material", 0}},
         {{"attributes", {{"POSITION", pyramid}}}, {"indices", faces}, {"material", 1}}}}}};
  scene.json["nodes"] = {{{"mesh", 0}}};
  scene.json["scenes"] = {{{"nodes", {0}}}};
  scene.json["scene"] = 0;
  return scene;
}

BundleFile smallTexton() {
  BundleFile file = smallestTexton();
  file.shape = PreviewShape::none;
  file.bundle.noises[0].name = "wool";
  file.bundle.tables[0].name = "wool.height.texton";
  return file;
}

} // namespace lichen::example
