// SPDX-License-Identifier: MIT
// `lichen apply` on materials with more features than a noise replaces: which images and extensions
// it removes and which it keeps.
#include "apply_run.h"

#include <catch2/catch.hpp>

using namespace lichen;
using namespace lichen::cli_test;
using nlohmann::json;

namespace {

constexpr const char* kUnlit = "KHR_materials_unlit";
constexpr const char* kGlossy = "KHR_materials_pbrSpecularGlossiness";
const std::string kDot = // a PNG of one pixel
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGP4z8AAAAMBAQDJ/"
    "pLvAAAAAElFTkSuQmCC";

/// The material 'wood' shows this image as its base colour.
void addImage(Apply& apply, const std::string& uri) {
  apply.scene.json["images"] = {{{"uri", uri}}};
  apply.scene.json["textures"] = {{{"source", 0}}};
  apply.material()["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
}

/// Both materials have the extension, and viewers must know it.
void addExtension(Apply& apply, const char* extension) {
  apply.scene.json["extensionsUsed"] = json::array({extension});
  apply.scene.json["extensionsRequired"] = json::array({extension});
  for (auto& material : apply.scene.json["materials"])
    material["extensions"][extension] = json::object();
}

} // namespace

TEST_CASE("an image that is missing or no image is an error in a .glb, and stays in a .gltf") {
  for (const std::string uri :
       {"old%20bark.png", "bark.png", "../bark.png", "https://host/bark.png",
        "data:image/png;base64,AAAA", "data:image/png;base64,#"}) {
    INFO(uri);
    Apply apply;
    addImage(apply, uri);
    apply.isText = true;
    apply.workplace.write("bark.png", std::string("not an image"));
    apply.refuses(moss(), "wood", {}, {"scene.gltf: /images/0/uri"}, kBadInput);
    succeed(apply.arguments(moss(), "wood", {}, "out.gltf"));
  }
}

TEST_CASE("an image beside the scene ties the output to its folder") {
  Apply apply;
  addImage(apply, "bark.png");
  std::filesystem::create_directory(apply.workplace.path("elsewhere"));
  apply.workplace.write("bark.png", smooth(8));
  checkRefusal(apply.arguments(moss(), "wood", {}, "elsewhere/out.glb"), kUsage,
               {"refers to files beside it", "bark.png"});
}

TEST_CASE("a .glb embeds images from data URIs") {
  Apply apply;
  apply.isText = true;
  apply.scene.json["images"] = {{{"uri", "data:image/png;base64," + kDot}}};
  REQUIRE(apply.run(moss(), "wood").code == 0);
  const json image = apply.output()["images"][0];
  CHECK(!image.contains("uri"));
  CHECK(image["mimeType"] == "image/png");
  CHECK(image.contains("bufferView"));
}

TEST_CASE("an extension that hides the noise is removed, and its name with its last use") {
  Apply apply;
  addExtension(apply, kUnlit);
  CHECK_THAT(apply.notes(moss(), "wood"),
             Catch::Contains("scene.glb: removed " + std::string(kUnlit) +
                             " from material 'wood': the noise needs"));
  const json one = apply.output();
  CHECK(one["materials"][0]["extensions"].size() == 1);
  CHECK(one["materials"][0]["extensions"].contains(kExtension));
  CHECK(one["materials"][1]["extensions"] == json{{kUnlit, json::object()}});
  CHECK(one["extensionsUsed"] == json{kUnlit, kExtension});
  CHECK(one["extensionsRequired"] == json{kUnlit});

  const json both = apply.document(moss(), "all", {"--mapping", "triplanar"});
  CHECK(!both["materials"][1]["extensions"].contains(kUnlit));
  CHECK(both["extensionsUsed"] == json{kExtension});
  CHECK(!both.contains("extensionsRequired"));
}

TEST_CASE("a specular-glossy material is refused, with advice, and others of its scene are not") {
  Apply apply;
  apply.scene.json["extensionsUsed"] = json::array({kGlossy});
  apply.material()["extensions"][kGlossy] = json::object();
  for (const char* material : {"wood", "all"})
    apply.refuses(moss(), material, {"--mapping", "triplanar"},
                  {"scene.glb: material 'wood' has " + std::string(kGlossy),
                   "convert it to metallic-roughness first"},
                  kBadInput);
  CHECK(apply.run(moss(), "1", {"--mapping", "triplanar"}).code == 0);
}

TEST_CASE("extensions that add to the core's shading stay, and so do texture transforms") {
  Apply apply;
  apply.material()["extensions"] = {
      {"KHR_materials_clearcoat", {{"clearcoatFactor", 1.0}}},
      {"KHR_materials_specular", {{"specularFactor", 0.5}}},
      {"KHR_materials_emissive_strength", {{"emissiveStrength", 2.0}}},
      {"VENDOR_materials_unknown", {{"anything", 1}}}};
  apply.scene.json["extensionsUsed"] = {"KHR_materials_clearcoat", "KHR_materials_specular",
                                        "KHR_materials_emissive_strength",
                                        "VENDOR_materials_unknown", "KHR_texture_transform"};
  apply.scene.json["textures"] = {json::object()};
  apply.material()["pbrMetallicRoughness"]["baseColorTexture"] = {
      {"index", 0}, {"extensions", {{"KHR_texture_transform", {{"scale", {2, 2}}}}}}};
  json after = apply.document(moss(), "wood")["materials"][0];
  after["extensions"].erase(kExtension);
  CHECK(after == json(apply.material()));
}
