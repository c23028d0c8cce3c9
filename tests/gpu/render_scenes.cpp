// SPDX-License-Identifier: MIT
// What a scene loads as: tangents, skins, nodes, cameras and notes. tests/unit/scene_meshes.cpp has
// the forms in which glTF stores vertices and indices.
#include "framing.h"
#include "loaded_scene.h"

#include <catch2/catch.hpp>

using namespace lichen;
using namespace lichen::test;
using renderer::Scene;
using renderer::Vertex;

namespace {

/// World positions in the order of the triangles' corners.
std::vector<glm::vec3> corners(const Scene& scene) {
  std::vector<glm::vec3> result;
  for (const renderer::Instance& instance : scene.instances)
    for (const std::uint32_t i : scene.primitives[instance.primitive].indices)
      result.emplace_back(
          instance.worldFromObject *
          glm::dvec4(scene.primitives[instance.primitive].vertices[i].position, 1.0));
  return result;
}

GltfScene quadScene() {
  GltfScene scene;
  const std::size_t material = scene.addMaterial(nlohmann::json::object());
  const std::size_t positions = scene.addFloats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, 3);
  scene.addMesh({{"POSITION", positions}}, scene.addIndices({0, 1, 2, 2, 1, 3}, 2), material);
  return scene;
}

} // namespace

TEST_CASE("a mesh without normals gets flat normals") {
  const Scene scene = loaded(quadScene());
  for (const Vertex& v : scene.primitives[0].vertices)
    CHECK(v.normal == glm::vec3(0, 0, 1));
}

TEST_CASE("tangents of the file are used for its normal texture, with its normals") {
  const glm::vec4 stored(0, 0.6f, 0.8f, 1.0f), none(0.0f);
  GltfScene scene = quadScene();
  nlohmann::json& material = scene.json["materials"][0];
  nlohmann::json& attributes = scene.json["meshes"][0]["primitives"][0]["attributes"];
  const auto tangent = [&] { return loaded(scene).primitives[0].vertices[0].tangent; };
  material["normalTexture"] = {{"index", scene.addChecker(1, {0.5f, 0.5f, 1}, {0.5f, 0.5f, 1})},
                               {"texCoord", 1}};
  std::vector<float> tangents;
  for (int v = 0; v < 4; ++v)
    tangents.insert(tangents.end(), {stored.x, stored.y, stored.z, stored.w});
  attributes["TANGENT"] = scene.addFloats(tangents, 4);
  CHECK(tangent() == none);
  attributes["NORMAL"] = scene.addFloats({1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0}, 3);
  CHECK(tangent() == stored);
  // A noise with normals replaces the texture.
  nlohmann::json& root = scene.json["extensions"]["LICHEN_materials_exemplar_noise"];
  nlohmann::json& use = material["extensions"]["LICHEN_materials_exemplar_noise"];
  root["noises"] = {{{"method", "tiling"},
                     {"revision", 1},
                     {"maps", {{{"target", "baseColor"}}, {{"target", "normal"}}}}}};
  use = {{"noise", 0}, {"texCoord", 1}};
  CHECK(tangent() == stored);
  use["texCoord"] = 0;
  CHECK(tangent() == none);
  root["noises"][0]["revision"] = 2; // an unsupported revision
  CHECK(tangent() == stored);
  root["noises"][0]["revision"] = 1;
  root["noises"][0]["maps"].erase(1);
  CHECK(tangent() == stored);
  // The loader ignores faults in the extension; the plugin reports them.
  for (const nlohmann::json& fault : {nlohmann::json(7), nlohmann::json(-1), nlohmann::json(0.5),
                                      nlohmann::json("x"), nlohmann::json::array({1})}) {
    use["noise"] = fault;
    CHECK(tangent() == stored);
    use["noise"] = 0;
    root["noises"] = fault;
    CHECK(tangent() == stored);
    root["noises"] = {{{"method", "tiling"}, {"revision", 1}, {"maps", fault}}};
    CHECK(tangent() == stored);
  }
}

TEST_CASE("a skinned mesh is where its first joint puts it, not its node") {
  GltfScene scene = quadScene();
  scene.json["nodes"][0].update({{"skin", 0}, {"translation", {7, 7, 7}}});
  const double half = std::sqrt(0.5); // a quarter turn, x to y
  scene.json["nodes"].push_back(
      {{"translation", {1e7, 2, 3}}, {"rotation", {0.0, 0.0, half, half}}});
  scene.json["scenes"][0]["nodes"].push_back(1);
  scene.json["skins"] = {{{"joints", {1, 0}}}};
  const auto corner = [&] { return glm::dvec3(loaded(scene).instances[0].worldFromObject[3]); };
  CHECK(corner() == glm::dvec3(1e7, 2, 3));
  std::vector<float> fromBind(32, 0.0f); // two matrices; the first moves by (-1, 0, 0)
  fromBind[0] = fromBind[5] = fromBind[10] = fromBind[15] = 1.0f;
  fromBind[12] = -1.0f;
  scene.json["skins"][0]["inverseBindMatrices"] = scene.addFloats(fromBind, 4);
  scene.json["accessors"].back().update({{"type", "MAT4"}, {"count", 2}});
  CHECK(glm::distance(corner(), glm::dvec3(1e7, 1, 3)) < 1e-6);
}

TEST_CASE("notes say that animations, weights of morph targets, points and lines are ignored") {
  GltfScene scene = quadScene();
  scene.json["meshes"][0]["weights"] = {0.0};
  CHECK(loaded(scene).notes.empty());
  scene.json["nodes"][0]["weights"] = {0.5};
  CHECK(loaded(scene).notes ==
        std::vector<std::string>{"morph targets are ignored; meshes are drawn as they are stored"});
  scene.json["nodes"][0].erase("weights");
  scene.json["animations"] = nlohmann::json::array();
  nlohmann::json line = scene.json["meshes"][0]["primitives"][0];
  line["mode"] = 1;
  scene.json["meshes"][0]["primitives"].push_back(line);
  const std::vector<std::string> notes = loaded(scene).notes;
  REQUIRE(notes.size() == 2);
  CHECK(notes[0] == "a primitive of mesh 0 without triangles is ignored");
  CHECK_THAT(notes[1], Catch::StartsWith("animations are ignored"));
}

TEST_CASE("nodes apply scale, rotation and translation in that order, parents last") {
  GltfScene scene = quadScene();
  const float half = std::sqrt(0.5f);
  scene.json["nodes"][0]["scale"] = {2, 1, 1};
  scene.json["nodes"][0]["rotation"] = {0, 0, half, half}; // x to y
  scene.json["nodes"][0]["translation"] = {10, 0, 0};
  scene.json["nodes"].push_back(
      {{"matrix", {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 3, 1}}, {"children", {0}}});
  scene.json["scenes"][0]["nodes"] = {1};
  const glm::vec3 corner = corners(loaded(scene))[1]; // (1, 0, 0)
  CHECK(corner.x == Approx(-10).margin(1e-5));
  CHECK(corner.y == Approx(2).margin(1e-5));
  CHECK(corner.z == Approx(3).margin(1e-5));
}

TEST_CASE("the automatic camera shows the whole subject") {
  GltfScene scene;
  const std::size_t material = scene.addMaterial(nlohmann::json::object());
  scene.addBall(material, {{"translation", {40, 1, 0}}});
  scene.addGround(material, 500.0f, 0.0f);
  const Scene made = loaded(scene);
  const renderer::Sphere subject = renderer::subjectOf(made).value();
  CHECK(subject.radius < 2.0f);
  for (const float aspect : {0.5f, 1.0f, 2.5f}) {
    const auto camera = renderer::chooseCamera(made, subject, "auto", aspect).value();
    const glm::mat4 clip = renderer::clipFromWorld(camera, {}, aspect, glm::vec2(0.0f));
    glm::vec2 low(2.0f), high(-2.0f);
    for (const Vertex& v : made.primitives[0].vertices) {
      const glm::vec4 p = clip * glm::vec4(v.position + glm::vec3(40, 1, 0), 1.0f);
      CHECK(std::abs(p.x) <= p.w);
      CHECK(std::abs(p.y) <= p.w);
      CHECK((p.z >= 0.0f && p.z <= p.w));
      low = glm::min(low, glm::vec2(p) / p.w);
      high = glm::max(high, glm::vec2(p) / p.w);
    }
    const int tight = aspect < 1.0f ? 0 : 1;
    // A ball's silhouette is nearer than its middle; 1.12 and 0.6 are framing.cpp's.
    const float slope = std::tan(0.3f) * std::min(aspect, 1.0f);
    const float edge = std::tan(std::asin(std::sin(std::atan(slope)) / 1.12f)) / slope;
    // Vertices of 64 x 32 facets lie within 0.07 radians of the silhouette.
    constexpr float kFacet = 0.5f * 0.07f * 0.07f;
    CHECK(low[tight] == Approx(-edge).margin(kFacet));
    CHECK(high[tight] == Approx(edge).margin(kFacet));
    CHECK(low[1 - tight] == Approx(-high[1 - tight]).margin(kFacet)); // the other axis is centred
  }
  const auto unknown = renderer::chooseCamera(made, subject, "side", 1.0f);
  REQUIRE_FALSE(unknown.ok());
  CHECK(unknown.error().kind == ErrorKind::usage);
}

TEST_CASE("a camera is found by its node's name or its own, and the error lists both") {
  GltfScene scene = quadScene();
  scene.addCamera(4.0f, 0.6f); // a camera named "front"
  scene.json["nodes"].back()["name"] = "Camera.left";
  scene.json["nodes"].push_back(scene.json["nodes"].back());
  scene.json["nodes"].back()["name"] = "Camera.right";
  scene.json["nodes"].back()["translation"] = {5, 0, 4};
  scene.json["scenes"][0]["nodes"].push_back(scene.json["nodes"].size() - 1);
  const Scene made = loaded(scene);
  const renderer::Sphere subject = renderer::subjectOf(made).value();
  const auto placeOf = [&](const char* name) {
    const auto chosen = renderer::chooseCamera(made, subject, name, 1.0f);
    REQUIRE(chosen.ok());
    return chosen.value().worldFromCamera[3].x;
  };
  CHECK(placeOf("Camera.left") == 0.0);
  CHECK(placeOf("Camera.right") == 5.0);
  CHECK(placeOf("front") == 0.0); // its first node
  const auto unknown = renderer::chooseCamera(made, subject, "side", 1.0f);
  REQUIRE_FALSE(unknown.ok());
  CHECK(unknown.error().message == "--camera side: the scene has no such camera; available: auto, "
                                   "Camera.left, Camera.right, front");
}

TEST_CASE(
    "a missing image is an error that names it, or only a note if a noise replaces the image") {
  using nlohmann::json;
  const char* const extension = "LICHEN_materials_exemplar_noise";
  GltfScene scene = quadScene();
  scene.json["images"] = {{{"uri", "absent%20bark.png"}}};
  scene.json["textures"] = {{{"source", 0}}};
  json& material = scene.json["materials"][0];
  material["extensions"][extension] = {{"noise", 0}};
  const auto readWith = [&](const char* slot, json maps) {
    GltfScene made = scene;
    made.json["extensions"][extension]["noises"] = {
        {{"method", "tiling"}, {"maps", std::move(maps)}, {"revision", 1}}};
    made.json["materials"][0][json::json_pointer(slot)] = {{"index", 0}};
    return readGltf(made);
  };
  const json color{{"target", "baseColor"}, {"channels", {"red", "green", "blue"}}};
  const json rough{{"target", "occlusionRoughnessMetallic"}, {"channels", {"roughness"}}};
  const json opacity{{"target", "opacity"}, {"channels", {"opacity"}}};
  const auto isNoted = [&](const char* slot, json maps) {
    const auto read = readWith(slot, std::move(maps));
    const std::string message = !read                        ? read.error().message
                                : read.value().notes.empty() ? "no note"
                                                             : read.value().notes.front();
    INFO(message);
    CHECK(message.find("/images/0: its file \"absent%20bark.png\" cannot be read") !=
          std::string::npos);
    return read.ok();
  };
  const char* const base = "/pbrMetallicRoughness/baseColorTexture";
  CHECK(isNoted(base, json::array({color})));
  CHECK_FALSE(isNoted(base, json::array({rough})));
  // Its metallic channel is still drawn.
  CHECK_FALSE(isNoted("/pbrMetallicRoughness/metallicRoughnessTexture", json::array({rough})));
  CHECK_FALSE(isNoted("/normalTexture", json::array({color})));
  material["alphaMode"] = "MASK"; // by the texture's alpha
  CHECK_FALSE(isNoted(base, json::array({color})));
  CHECK(isNoted(base, json::array({color, opacity})));
}
