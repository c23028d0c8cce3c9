// SPDX-License-Identifier: MIT
// `lichen apply` on materials with extensions: which it removes and which it keeps.
#include "apply_run.h"

#include <lichen/gltf_scene.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace lichen;
using namespace lichen::cli_test;
using nlohmann::json;

namespace {

constexpr const char* kUnlit = "KHR_materials_unlit";
constexpr const char* kGlossy = "KHR_materials_pbrSpecularGlossiness";

json output(const Workplace& workplace) {
  return GltfScene::open(workplace.path("out.glb")).value().document();
}

/// Both materials have the extension, and viewers must know it.
example::TinyScene sceneWith(const char* extension, const json& content = json::object()) {
  example::TinyScene scene = example::tableScene();
  scene.json["extensionsUsed"] = json::array({extension});
  scene.json["extensionsRequired"] = json::array({extension});
  for (auto& material : scene.json["materials"])
    material["extensions"][extension] = content;
  return scene;
}

} // namespace

TEST_CASE("an extension that hides the noise is removed, and its name with its last use") {
  const Workplace workplace;
  const std::string moss = bake(workplace, workplace.write("moss.png", smooth(8)), "moss.glb");
  for (const char* extension : {kUnlit, kGlossy}) {
    INFO(extension);
    const std::string path = writeScene(workplace, sceneWith(extension));
    const Ended ended = apply(workplace, path, moss, "wood");
    REQUIRE(ended.code == 0);
    CHECK_THAT(ended.errors, Catch::Contains("scene.glb: removed " + std::string(extension) +
                                             " from material 'wood': the noise needs"));
    const json one = output(workplace);
    CHECK(one["materials"][0]["extensions"].size() == 1);
    CHECK(one["materials"][0]["extensions"].contains(kExtension));
    CHECK(one["materials"][1]["extensions"] == json{{extension, json::object()}});
    CHECK(one["extensionsUsed"] == json{extension, kExtension});
    CHECK(one["extensionsRequired"] == json{extension});

    const json both = applied(workplace, path, moss, "all", {"--mapping", "triplanar"});
    CHECK(!both["materials"][1]["extensions"].contains(extension));
    CHECK(both["extensionsUsed"] == json{kExtension});
    CHECK(!both.contains("extensionsRequired"));
  }
}

TEST_CASE("a specular-glossy material keeps in the core what the noise does not bring") {
  const Workplace workplace;
  const std::string moss = bake(workplace, workplace.write("moss.png", smooth(8)), "moss.glb");
  const std::string wool = writeTexton(workplace); // height only
  example::TinyScene scene =
      sceneWith(kGlossy, {{"diffuseTexture", {{"index", 0}, {"texCoord", 0}}},
                          {"diffuseFactor", {0.5, 0.25, 0.125, 1.0}},
                          {"specularGlossinessTexture", {{"index", 1}}},
                          {"glossinessFactor", 0.75}});
  scene.json["images"] = {{{"uri", "diffuse.png"}}, {{"uri", "glossiness.png"}}};
  scene.json["textures"] = {{{"source", 0}}, {{"source", 1}}};
  scene.json["materials"][0].erase("pbrMetallicRoughness");
  const json texture{{"index", 0}, {"texCoord", 0}};

  const json colored = applied(workplace, writeScene(workplace, scene), moss, "wood");
  CHECK(colored["materials"][0]["pbrMetallicRoughness"] ==
        json{{"baseColorTexture", texture}, {"metallicFactor", 0.0}, {"roughnessFactor", 0.25}});

  const Ended ended = apply(workplace, writeScene(workplace, scene), wool, "wood");
  REQUIRE(ended.code == 0);
  CHECK_THAT(ended.errors, Catch::Contains("baseColorTexture of material 'wood' stays visible"));
  CHECK(output(workplace)["materials"][0]["pbrMetallicRoughness"] ==
        json{{"baseColorTexture", texture},
             {"baseColorFactor", {0.5, 0.25, 0.125, 1.0}},
             {"metallicFactor", 0.0},
             {"roughnessFactor", 0.25}});

  // The core's own description is complete.
  scene.json["materials"][0]["pbrMetallicRoughness"] = {{"metallicFactor", 0.5}};
  const json described = applied(workplace, writeScene(workplace, scene), moss, "wood");
  CHECK(described["materials"][0]["pbrMetallicRoughness"] == json{{"metallicFactor", 0.5}});
}

TEST_CASE("images of a removed specular-glossiness may be missing") {
  const Workplace workplace;
  const std::string moss = bake(workplace, workplace.write("moss.png", smooth(8)), "moss.glb");
  const std::string wool = writeTexton(workplace);
  example::TinyScene scene = sceneWith(kGlossy);
  scene.json["materials"][0]["extensions"][kGlossy] = {
      {"diffuseTexture", {{"index", 0}}}, {"specularGlossinessTexture", {{"index", 1}}}};
  scene.json["materials"][0].erase("pbrMetallicRoughness");
  scene.json["images"] = {{{"uri", "diffuse.png"}}, {{"uri", "glossiness.png"}}};
  scene.json["textures"] = {{{"source", 0}}, {{"source", 1}}};
  workplace.write("scene.bin", scene.binary);
  const std::string path = workplace.write("scene.gltf", scene.gltf("scene.bin"));
  const Ended ended = apply(workplace, path, moss, "wood");
  CHECK(ended.code == 0);
  CHECK_THAT(ended.errors, Catch::Contains("diffuse.png") && Catch::Contains("glossiness.png"));
  // A noise without colours leaves the diffuse texture.
  checkRefusal(
      {"apply", path, "--noise", wool, "--material", "wood", "-o", workplace.path("x.glb")},
      int(ErrorKind::badInput), {"/images/0/uri", "diffuse.png"});
}

TEST_CASE("extensions that add to the core's shading stay, and so do texture transforms") {
  const Workplace workplace;
  const std::string moss = bake(workplace, workplace.write("moss.png", smooth(8)), "moss.glb");
  example::TinyScene scene = example::tableScene();
  const json extensions{{"KHR_materials_clearcoat", {{"clearcoatFactor", 1.0}}},
                        {"KHR_materials_specular", {{"specularFactor", 0.5}}},
                        {"KHR_materials_emissive_strength", {{"emissiveStrength", 2.0}}},
                        {"VENDOR_materials_unknown", {{"anything", 1}}}};
  scene.json["extensionsUsed"] = {"KHR_materials_clearcoat", "KHR_materials_specular",
                                  "KHR_materials_emissive_strength", "VENDOR_materials_unknown",
                                  "KHR_texture_transform"};
  scene.json["materials"][0]["extensions"] = extensions;
  const json texture{{"index", 0},
                     {"extensions", {{"KHR_texture_transform", {{"scale", {2, 2}}}}}}};
  scene.json["textures"] = {json::object()};
  scene.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = texture;
  const json before = scene.json;
  json after = applied(workplace, writeScene(workplace, scene), moss, "wood")["materials"][0];
  after["extensions"].erase(kExtension);
  CHECK(after == before["materials"][0]);
}
