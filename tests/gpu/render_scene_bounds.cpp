// SPDX-License-Identifier: MIT
// Bounds of a scene: memory and draws in proportion to the file, and only files in its own folder.
#include "render_gltf.h"
#include "scene.h"

#include <catch2/catch.hpp>

#include <numeric>

using namespace lichen;
using namespace lichen::test;
using nlohmann::json;

namespace {

Error loadError(const TemporaryFolder& folder, const GltfScene& scene) {
  const auto read = renderer::readScene(writeInto(folder, "scene.glb", scene.glb()));
  REQUIRE_FALSE(read.ok());
  INFO(read.error().message);
  CHECK(read.error().message.find('\n') == std::string::npos);
  return read.error();
}

} // namespace

TEST_CASE("a small file with excessive draws is an error") {
  const TemporaryFolder folder;
  const auto placed = [](GltfScene scene, std::size_t times) {
    json nodes = json::array();
    for (std::size_t i = 0; i < times; ++i)
      nodes.push_back(i);
    scene.json["nodes"] = json(std::vector<json>(times, json{{"mesh", 0}}));
    scene.json["scenes"][0]["nodes"] = std::move(nodes);
    return scene;
  };
  GltfScene twoPrimitives = triangleScene();
  json& primitives = twoPrimitives.json["meshes"][0]["primitives"];
  primitives.push_back(primitives[0]);
  const Error instances =
      loadError(folder, placed(twoPrimitives, renderer::kMaxSceneInstances / 2 + 1));
  CHECK(instances.kind == ErrorKind::resources);
  CHECK(instances.message.find(std::to_string(renderer::kMaxSceneInstances)) != std::string::npos);

  // A mesh of zeros takes no bytes in the file.
  constexpr std::size_t kZeros = std::size_t(1) << 16;
  GltfScene large = triangleScene();
  large.json["accessors"].push_back(
      {{"componentType", 5126}, {"type", "VEC3"}, {"count", 3 * kZeros}});
  large.json["meshes"][0]["primitives"] = {
      {{"attributes", {{"POSITION", large.json["accessors"].size() - 1}}}}};
  const Error drawn = loadError(folder, placed(large, renderer::kMaxDrawnVertices / kZeros));
  CHECK(drawn.kind == ErrorKind::resources);
  CHECK(drawn.message.find(std::to_string(renderer::kMaxDrawnVertices)) != std::string::npos);
}

TEST_CASE("buffers that exceed the size of a GLB in total are an error before they are read") {
  const TemporaryFolder folder;
  GltfScene scene = triangleScene();
  for (int i = 0; i < 2; ++i)
    scene.json["buffers"].push_back(
        {{"byteLength", renderer::kMaxBufferBytes / 2}, {"uri", "absent.bin"}});
  const Error error = loadError(folder, scene);
  CHECK(error.kind == ErrorKind::resources);
  CHECK(error.message.find(std::to_string(renderer::kMaxBufferBytes)) != std::string::npos);
}

TEST_CASE("many images that refer to one large file are an error") {
  const TemporaryFolder folder;
  constexpr std::size_t kLarge = std::size_t(1) << 26;
  const auto file = writeInto(folder, "large.png", {});
  std::filesystem::resize_file(file, kLarge);
  GltfScene scene = triangleScene();
  scene.json["images"] =
      json(std::vector<json>(renderer::kMaxImageBytes / kLarge + 1, {{"uri", "large.png"}}));
  const Error error = loadError(folder, scene);
  CHECK(error.kind == ErrorKind::resources);
  CHECK(error.message.find(std::to_string(renderer::kMaxImageBytes)) != std::string::npos);
}

TEST_CASE("images that share a bufferView take no extra memory") {
  const TemporaryFolder folder;
  constexpr std::size_t kLarge = std::size_t(1) << 20;
  GltfScene scene = triangleScene();
  const std::size_t view = scene.addView(std::vector<std::byte>(kLarge));
  scene.json["images"] =
      json(std::vector<json>(renderer::kMaxImageBytes / kLarge + 1, {{"bufferView", view}}));
  CHECK(renderer::readScene(writeInto(folder, "shared.glb", scene.glb())).ok());
}

TEST_CASE("a strip counts as its triangles") {
  const TemporaryFolder folder;
  GltfScene scene = triangleScene();
  // Within the bounds as stored, but not with three vertices and indices per triangle.
  const std::size_t count = renderer::kMaxSceneVertices / 6;
  scene.json["accessors"].push_back({{"componentType", 5126}, {"type", "VEC3"}, {"count", count}});
  scene.json["meshes"][0]["primitives"] = {
      {{"attributes", {{"POSITION", scene.json["accessors"].size() - 1}}}, {"mode", 5}}};
  const Error error = loadError(folder, scene);
  CHECK(error.kind == ErrorKind::resources);
  CHECK(error.message.find(std::to_string(renderer::kMaxSceneVertices)) != std::string::npos);
}

TEST_CASE("a point counts as the triangles of its octahedron") {
  const TemporaryFolder folder;
  GltfScene scene = triangleScene();
  const std::size_t count = renderer::kMaxSceneVertices / 50;
  scene.json["accessors"].push_back({{"componentType", 5126}, {"type", "VEC3"}, {"count", count}});
  scene.json["meshes"][0]["primitives"] = {
      {{"attributes", {{"POSITION", scene.json["accessors"].size() - 1}}}, {"mode", 0}}};
  CHECK(loadError(folder, scene).kind == ErrorKind::resources);
}

TEST_CASE("a small file with excessive deformation is an error") {
  const TemporaryFolder folder;
  constexpr std::size_t kTargets = 1000;
  const std::size_t count = renderer::kMaxSceneVertices / kTargets;
  GltfScene targets = triangleScene();
  targets.json["accessors"].push_back(
      {{"componentType", 5126}, {"type", "VEC3"}, {"count", count}});
  const std::size_t zeros = targets.json["accessors"].size() - 1;
  json& mesh = targets.json["meshes"][0];
  mesh["primitives"] = {{{"attributes", {{"POSITION", zeros}}},
                         {"targets", json(std::vector<json>(kTargets, {{"POSITION", zeros}}))}}};
  mesh["weights"] = std::vector<int>(kTargets, 1);
  const Error passes = loadError(folder, targets);
  CHECK(passes.kind == ErrorKind::resources);
  CHECK(passes.message.find(std::to_string(renderer::kMaxSceneVertices)) != std::string::npos);

  // Each node that deforms a mesh has its own vertices, if there are any.
  GltfScene nodes = triangleScene();
  constexpr std::size_t kNodes = 1024;
  json primitive{{"attributes", json::object()}};
  nodes.json["meshes"][0]["primitives"] =
      json(std::vector<json>(renderer::kMaxSceneInstances / kNodes + 1, primitive));
  nodes.json["nodes"] = json(std::vector<json>(kNodes, {{"mesh", 0}, {"weights", {1}}}));
  std::vector<std::size_t> all(kNodes);
  std::iota(all.begin(), all.end(), 0u);
  nodes.json["scenes"][0]["nodes"] = all;
  const Error loads = loadError(folder, nodes);
  CHECK(loads.kind == ErrorKind::resources);
  CHECK(loads.message.find(std::to_string(renderer::kMaxSceneInstances)) != std::string::npos);
}

TEST_CASE("buffers load only from inside the scene's folder, however the path is written") {
  const TemporaryFolder folder;
  const std::filesystem::path inside = folder.path() / "scene";
  std::filesystem::create_directory(inside);
  std::filesystem::create_directory(inside / "sub");
  GltfScene scene = triangleScene();
  (void)writeInto(folder, "outside.bin", scene.binary);
  (void)writeInto(folder, "scene/inside.bin", scene.binary);
  std::filesystem::create_symlink(folder.path() / "outside.bin", inside / "link.bin");
  std::filesystem::create_directory_symlink(folder.path(), inside / "way");
  const auto readsFrom = [&](const char* uri) {
    scene.json["buffers"][0]["uri"] = uri;
    const std::string text = scene.json.dump();
    return renderer::readScene(
               writeInto(folder, "scene/scene.gltf", std::as_bytes(std::span(text))))
        .ok();
  };
  CHECK(readsFrom("inside.bin"));
  CHECK(readsFrom("sub/../inside.bin"));
  CHECK_FALSE(readsFrom("../outside.bin"));
  CHECK_FALSE(readsFrom("%2E%2E/outside.bin"));
  CHECK_FALSE(readsFrom("link.bin"));
  CHECK_FALSE(readsFrom("way/outside.bin"));
  CHECK_FALSE(readsFrom((folder.path() / "outside.bin").c_str()));
  CHECK_FALSE(readsFrom("sub"));
}
