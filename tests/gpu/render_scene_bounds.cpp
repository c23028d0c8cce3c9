// SPDX-License-Identifier: MIT
// Bounds of a scene: memory and draws in proportion to the file, and only files in its own folder.
#include "loaded_scene.h"

#include <numeric>

using namespace lichen;
using namespace lichen::test;
using nlohmann::json;

namespace {

/// Requires that a scene needs more memory or time than allowed, which the one line names.
void checkExceeds(const Result<renderer::Scene>& read, std::size_t most) {
  REQUIRE_FALSE(read.ok());
  INFO(read.error().message);
  CHECK(read.error().message.find('\n') == std::string::npos);
  CHECK(read.error().kind == ErrorKind::resources);
  CHECK(read.error().message.find(std::to_string(most)) != std::string::npos);
}

/// The first mesh has one primitive of so many zeros, which take no bytes in the file.
GltfScene zerosScene(std::size_t count, int mode = 4) {
  GltfScene scene = triangleScene();
  scene.json["accessors"].push_back({{"componentType", 5126}, {"type", "VEC3"}, {"count", count}});
  scene.json["meshes"][0]["primitives"] = {
      {{"attributes", {{"POSITION", scene.json["accessors"].size() - 1}}}, {"mode", mode}}};
  return scene;
}

/// So many nodes like this.
GltfScene placed(GltfScene scene, std::size_t times, const json& node = {{"mesh", 0}}) {
  std::vector<std::size_t> all(times);
  std::iota(all.begin(), all.end(), 0u);
  scene.json["nodes"] = json(std::vector<json>(times, node));
  scene.json["scenes"][0]["nodes"] = all;
  return scene;
}

} // namespace

TEST_CASE("a small file with excessive draws is an error") {
  GltfScene two = triangleScene();
  json& primitives = two.json["meshes"][0]["primitives"];
  primitives.push_back(primitives[0]);
  checkExceeds(readGltf(placed(two, renderer::kMaxSceneInstances / 2 + 1)),
               renderer::kMaxSceneInstances);
  constexpr std::size_t kZeros = std::size_t(1) << 16;
  checkExceeds(readGltf(placed(zerosScene(3 * kZeros), renderer::kMaxDrawnVertices / kZeros)),
               renderer::kMaxDrawnVertices);
  // A strip counts as its triangles.
  checkExceeds(readGltf(zerosScene(renderer::kMaxSceneVertices / 6, 5)),
               renderer::kMaxSceneVertices);
}

TEST_CASE("many skins of matrices that take no bytes in the file are an error") {
  constexpr std::size_t kZeros = std::size_t(1) << 22;
  GltfScene scene = triangleScene();
  scene.json["accessors"].push_back({{"componentType", 5126}, {"type", "MAT4"}, {"count", kZeros}});
  const std::size_t skins = renderer::kMaxSceneVertices / kZeros + 1;
  const json skin{{"joints", {0}}, {"inverseBindMatrices", scene.json["accessors"].size() - 1}};
  scene.json["skins"] = json(std::vector<json>(skins, skin));
  scene = placed(scene, skins);
  for (std::size_t i = 0; i < skins; ++i)
    scene.json["nodes"][i]["skin"] = i;
  checkExceeds(readGltf(scene), renderer::kMaxSceneVertices);
}

TEST_CASE("buffers that exceed the size of a GLB in total are an error before they are read") {
  GltfScene scene = triangleScene();
  for (int i = 0; i < 2; ++i)
    scene.json["buffers"].push_back(
        {{"byteLength", renderer::kMaxBufferBytes / 2}, {"uri", "absent.bin"}});
  checkExceeds(readGltf(scene), renderer::kMaxBufferBytes);
}

TEST_CASE("many images that refer to one large file are an error, unless they share a bufferView") {
  const TemporaryFolder folder;
  constexpr std::size_t kLarge = std::size_t(1) << 26;
  std::filesystem::resize_file(writeInto(folder, "large.png", {}), kLarge);
  GltfScene scene = triangleScene();
  scene.json["images"] =
      json(std::vector<json>(renderer::kMaxImageBytes / kLarge + 1, {{"uri", "large.png"}}));
  checkExceeds(renderer::readScene(writeInto(folder, "scene.glb", scene.glb())),
               renderer::kMaxImageBytes);
  constexpr std::size_t kShared = std::size_t(1) << 20;
  const std::size_t view = scene.addView(std::vector<std::byte>(kShared));
  scene.json["images"] =
      json(std::vector<json>(renderer::kMaxImageBytes / kShared + 1, {{"bufferView", view}}));
  CHECK(readGltf(scene).ok());
}
