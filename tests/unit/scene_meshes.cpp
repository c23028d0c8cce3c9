// SPDX-License-Identifier: MIT
// Meshes of scenes from other programs: how they are read, and which are rejected.
#include "opened_scene.h"
#include "tiny_scene.h"

#include <lichen/gltf_scene.h>

#include <catch2/catch.hpp>

using namespace lichen;
using example::TinyScene;
using nlohmann::json;

namespace {

using Positions = std::vector<std::array<float, 3>>;

PrimitiveGeometry geometryOf(const TinyScene& scene, PrimitivePlace place = {}) {
  const Folder folder;
  GltfScene opened = openScene(folder.write("scene.glb", scene.glb()));
  Result<PrimitiveGeometry> geometry = opened.geometry(place);
  INFO((geometry ? "" : geometry.error().message));
  REQUIRE(geometry.ok());
  return std::move(geometry).value();
}

/// The error message from opening a scene or reading its first primitive.
std::string refusalOf(const TinyScene& scene) {
  const Folder folder;
  Result<GltfScene> opened = GltfScene::open(folder.write("scene.glb", scene.glb()));
  const auto error =
      opened ? opened.value().geometry({0, 0}) : Result<PrimitiveGeometry>(opened.error());
  REQUIRE(!error.ok());
  CHECK(error.error().kind == ErrorKind::badInput);
  CHECK_THAT(error.error().message, Catch::Contains("scene.glb: "));
  return error.error().message;
}

const Positions kSquare{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

} // namespace

TEST_CASE("positions and indices are read from every storage format") {
  TinyScene scene = example::tableScene();
  CHECK(geometryOf(scene).positions == kSquare);
  CHECK(geometryOf(scene).normals == Positions(4, {0, 0, 1}));
  const std::vector<std::uint32_t> triangles{0, 1, 2, 0, 2, 3};
  CHECK(geometryOf(scene).triangles == triangles);
  CHECK(geometryOf(scene, {0, 1}).normals.empty());
  auto& primitive = scene.json["meshes"][0]["primitives"][0];
  primitive["indices"] =
      scene.addAccessor(std::vector<std::uint8_t>{0, 1, 2, 0, 2, 3}, "SCALAR", 5121, 1);
  CHECK(geometryOf(scene).triangles == triangles);
  primitive["indices"] =
      scene.addAccessor(std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}, "SCALAR", 5125, 1);
  CHECK(geometryOf(scene).triangles == triangles);

  // One vertex every 20 bytes; the position is behind 4 other bytes.
  std::vector<float> interleaved;
  for (const auto& p : kSquare)
    interleaved.insert(interleaved.end(), {9.0f, p[0], p[1], p[2], 9.0f});
  const std::size_t view = scene.addView(std::as_bytes(std::span(interleaved)), 20);
  scene.json["accessors"].push_back({{"bufferView", view},
                                     {"byteOffset", 4},
                                     {"componentType", 5126},
                                     {"count", 4},
                                     {"type", "VEC3"}});
  primitive["attributes"]["POSITION"] = scene.json["accessors"].size() - 1;
  CHECK(geometryOf(scene).positions == kSquare);
}

TEST_CASE("quantized and sparse positions are read") {
  TinyScene scene = example::tableScene();
  auto& attributes = scene.json["meshes"][0]["primitives"][0]["attributes"];
  const std::vector<std::int16_t> shorts{0, 0,      0,     0, 32767, 0, 0, 0,
                                         0, -32768, 16384, 0, 0,     0, 0, 0};
  const std::size_t view = scene.addView(std::as_bytes(std::span(shorts)), 8);
  scene.json["accessors"].push_back({{"bufferView", view},
                                     {"componentType", 5122},
                                     {"normalized", true},
                                     {"count", 4},
                                     {"type", "VEC3"}});
  attributes["POSITION"] = scene.json["accessors"].size() - 1;
  CHECK(geometryOf(scene).positions ==
        Positions{{0, 0, 0}, {1, 0, 0}, {0, -1, 16384.0f / 32767.0f}, {0, 0, 0}});

  const std::vector<std::uint16_t> where{1, 3};
  const std::vector<float> what{5, 6, 7, 8, 9, 10};
  const std::size_t whereView = scene.addView(std::as_bytes(std::span(where)));
  const std::size_t whatView = scene.addView(std::as_bytes(std::span(what)));
  scene.json["accessors"].push_back(
      {{"componentType", 5126},
       {"count", 4},
       {"type", "VEC3"},
       {"sparse",
        {{"count", 2},
         {"indices", {{"bufferView", whereView}, {"componentType", 5123}}},
         {"values", {{"bufferView", whatView}}}}}});
  attributes["POSITION"] = scene.json["accessors"].size() - 1;
  CHECK(geometryOf(scene).positions == Positions{{0, 0, 0}, {5, 6, 7}, {0, 0, 0}, {8, 9, 10}});
}

TEST_CASE("strips, fans and vertices without indices become lists of triangles") {
  TinyScene scene = example::tableScene();
  auto& primitive = scene.json["meshes"][0]["primitives"][0];
  using List = std::vector<std::uint32_t>;
  primitive.erase("indices");
  CHECK(geometryOf(scene).triangles == List{0, 1, 2}); // with four vertices
  primitive["mode"] = 5;
  CHECK(geometryOf(scene).triangles == List{0, 1, 2, 1, 3, 2});
  primitive["mode"] = 6;
  CHECK(geometryOf(scene).triangles == List{1, 2, 0, 2, 3, 0});
}

// Faults of accessors are in tests/gpu/render_hostile_scenes.cpp: the renderer reads them by the
// same functions.
TEST_CASE("the error for a mesh that cannot be read names it") {
  const auto broken = [](const auto& alter) {
    TinyScene scene = example::tableScene();
    alter(scene, scene.json["meshes"][0]["primitives"][0]);
    return refusalOf(scene);
  };
  using Catch::Contains;
  CHECK_THAT(broken([](auto&, auto& p) { p["mode"] = 1; }),
             Contains("primitive 0 of mesh 'table'") && Contains("lines"));
  CHECK_THAT(broken([](auto&, auto& p) {
               p["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0}};
             }),
             Contains("KHR_draco_mesh_compression"));
  CHECK_THAT(broken([](auto& s, auto&) {
               s.json["extensionsRequired"] = {"EXT_meshopt_compression"};
               s.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0}};
             }),
             Contains("EXT_meshopt_compression"));
  CHECK_THAT(broken([](auto&, auto& p) { p["attributes"].erase("POSITION"); }),
             Contains("no POSITION"));
  CHECK_THAT(broken([](auto&, auto& p) { p["attributes"]["POSITION"] = 99; }), Contains("99"));
  CHECK_THAT(broken([](auto&, auto& p) { p["attributes"] = 0; }), Contains("attributes"));
  CHECK_THAT(broken([](auto&, auto& p) { p["material"] = 2; }), Contains("/material"));
  CHECK_THAT(broken([](auto&, auto& p) { p["attributes"]["NORMAL"] = 3; }),
             Contains("/accessors/3"));
  CHECK_THAT(broken([](auto& s, auto&) { s.json["materials"] = json::object(); }),
             Contains("/materials"));
  for (const json& materials : {json(5), json("x"), json::array({1})})
    CHECK_THAT(broken([&](auto& s, auto&) { s.json["materials"] = materials; }),
               Contains("/materials: not an array of objects"));
  CHECK_THAT(broken([](auto& s, auto&) { s.json["meshes"][0]["primitives"] = {1}; }),
             Contains("/meshes/0/primitives"));
  CHECK_THAT(broken([](auto& s, auto& p) {
               p["indices"] = s.addAccessor(std::vector<std::uint16_t>{0, 1, 4}, "SCALAR", 5123, 1);
             }),
             Contains("index 4"));
}

TEST_CASE("a fault is reported for every primitive that has it") {
  const Folder folder;
  const std::string text = example::tableScene().gltf("absent.bin");
  GltfScene opened = openScene(folder.write("scene.gltf", std::as_bytes(std::span(text))));
  for (int again = 0; again < 2; ++again)
    for (std::size_t primitive = 0; primitive < 2; ++primitive) {
      const PrimitivePlace place{0, primitive};
      CHECK(!opened.geometry(place).ok());
      const auto checked = opened.checkVertices(place);
      REQUIRE(!checked.ok());
      CHECK_THAT(checked.error().message, Catch::Contains("/buffers/0/uri") &&
                                              Catch::Contains(opened.primitiveTitle(place)));
    }
}

TEST_CASE("shared vertices are checked once, and indices against each") {
  const Folder folder;
  TinyScene scene = example::tableScene();
  auto& primitives = scene.json["meshes"][0]["primitives"];
  const auto first = primitives[0];
  primitives = {first, first, first};
  primitives[1]["indices"] =
      scene.addAccessor(std::vector<std::uint16_t>{0, 1, 4}, "SCALAR", 5123, 1);
  primitives[2]["attributes"]["TEXCOORD_0"] = primitives[0]["attributes"]["POSITION"];
  GltfScene opened = openScene(folder.write("scene.glb", scene.glb()));
  CHECK(opened.checkVertices({0, 0}).ok());
  const auto outside = opened.checkVertices({0, 1}), type = opened.checkVertices({0, 2});
  REQUIRE(!outside.ok());
  REQUIRE(!type.ok());
  CHECK_THAT(outside.error().message, Catch::Contains("index 4"));
  CHECK_THAT(type.error().message, Catch::Contains("VEC2"));
}

TEST_CASE("an accessor with more elements than bytes is an error before memory is allocated") {
  static constexpr std::size_t kMost = std::size_t(1) << 25; // elements that any accessor may have
  static constexpr std::size_t kRoom = std::size_t(1) << 20; // bytes; they need 400 MB
  const auto refusal = [](const auto& alter) {
    TinyScene scene = example::tableScene();
    alter(scene, scene.json["meshes"][0]["primitives"][0]);
    const test::ExhaustedMemory measured;
    std::string message = refusalOf(scene);
    CHECK(test::ExhaustedMemory::largest() < kRoom);
    return message;
  };
  using Catch::Contains;
  CHECK_THAT(
      refusal([](auto& s, auto& p) {
        s.json["accessors"][p["attributes"]["POSITION"].template get<std::size_t>()]["count"] =
            kMost;
      }),
      Contains("33554432 elements of 12 bytes") && Contains("; the view has"));
  CHECK_THAT(refusal([](auto& s, auto& p) {
               s.json["accessors"][p["indices"].template get<std::size_t>()]["count"] = kMost;
             }),
             Contains("33554432 elements of") && Contains("; the view has"));
  CHECK_THAT(refusal([](auto& s, auto& p) {
               s.json["accessors"][p["attributes"]["POSITION"].template get<std::size_t>()] = {
                   {"componentType", 5126}, {"count", kMost}, {"type", "VEC3"}};
             }),
             Contains("33554432 without a bufferView; expected 1 to 4194304"));
}
