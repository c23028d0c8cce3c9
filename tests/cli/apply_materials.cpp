// SPDX-License-Identifier: MIT
// `lichen apply` on materials with more features than a noise replaces.
#include "apply_run.h"

#include <lichen/gltf_scene.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace lichen;
using namespace lichen::cli_test;
using nlohmann::json;

namespace {

const std::string kDot = // a PNG of one pixel
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGP4z8AAAAMBAQDJ/"
    "pLvAAAAAElFTkSuQmCC";

} // namespace

TEST_CASE("a missing image is an error unless the noise replaces everything that shows it") {
  const Workplace workplace;
  const std::string moss = bake(workplace, workplace.write("moss.png", smooth(8)), "moss.glb");
  example::TinyScene scene = example::tableScene();
  scene.json["images"] = {{{"uri", "old%20bark.png"}}};
  scene.json["textures"] = {{{"source", 0}}};
  scene.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
  const auto write = [&] {
    workplace.write("scene.bin", scene.binary);
    return workplace.write("scene.gltf", scene.gltf("scene.bin"));
  };
  const Ended ended = apply(workplace, write(), moss, "wood");
  CHECK(ended.code == 0);
  CHECK_THAT(ended.errors, Catch::Contains("/images/0: the file \"old%20bark.png\" is missing, "
                                           "but the noise replaces everything that shows it"));
  CHECK(GltfScene::open(workplace.path("out.glb")).value().document()["images"][0]["uri"] ==
        "old%20bark.png");
  const auto refused = [&] {
    checkRefusal(
        {"apply", write(), "--noise", moss, "--material", "wood", "-o", workplace.path("x.glb")},
        int(ErrorKind::badInput), {"scene.gltf: /images/0/uri", "old bark.png"});
  };
  scene.json["materials"][1]["emissiveTexture"] = {{"index", 0}}; // the material without the noise
  refused();
  scene.json["materials"][1].erase("emissiveTexture");
  scene.json["materials"][0]["alphaMode"] = "BLEND"; // blends by the texture's alpha
  refused();
  scene.json["materials"][0].erase("alphaMode");
  scene.json["materials"][0]["extensions"]["KHR_materials_sheen"]["sheenColorTexture"] = {
      {"index", 0}};
  refused();
}

TEST_CASE(
    "an image that is no image is an error unless the noise replaces everything that shows it") {
  const Workplace workplace;
  const std::string moss = bake(workplace, workplace.write("moss.png", smooth(8)), "moss.glb");
  workplace.write("bark.png", "not an image");
  for (const std::string uri : {"bark.png", "../bark.png", "https://host/bark.png",
                                "data:image/png;base64,AAAA", "data:image/png;base64,#"}) {
    INFO(uri);
    example::TinyScene scene = example::tableScene();
    scene.json["images"] = {{{"uri", uri}}};
    scene.json["textures"] = {{{"source", 0}}};
    scene.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    workplace.write("scene.bin", scene.binary);
    const Ended ended =
        apply(workplace, workplace.write("scene.gltf", scene.gltf("scene.bin")), moss, "wood");
    CHECK(ended.code == 0);
    CHECK_THAT(ended.errors, Catch::Contains("/images/0: ") &&
                                 Catch::Contains("is not a readable PNG, JPEG, WebP or KTX2, but "
                                                 "the noise replaces everything that shows it"));
    scene.json["materials"][1]["emissiveTexture"] = {{"index", 0}};
    checkRefusal({"apply", workplace.write("scene.gltf", scene.gltf("scene.bin")), "--noise", moss,
                  "--material", "wood", "-o", workplace.path("x.glb")},
                 int(ErrorKind::badInput), {"scene.gltf: /images/0/uri"});
  }
}

TEST_CASE("a missing image that the noise replaces does not tie the output to the scene's folder") {
  const Workplace workplace;
  const std::string moss = bake(workplace, workplace.write("moss.png", smooth(8)), "moss.glb");
  std::filesystem::create_directory(workplace.path("elsewhere"));
  example::TinyScene scene = example::tableScene();
  scene.json["images"] = {{{"uri", "bark.png"}}};
  scene.json["textures"] = {{{"source", 0}}};
  scene.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
  const std::string path = writeScene(workplace, scene);
  CHECK(apply(workplace, path, moss, "wood", {}, "elsewhere/out.glb").code == 0);
  CHECK(apply(workplace, path, moss, "wood", {}, "elsewhere/out.gltf").code == 0);
  workplace.write("bark.png", smooth(8)); // other viewers show it
  checkRefusal({"apply", path, "--noise", moss, "--material", "wood", "-o",
                workplace.path("elsewhere/out.glb")},
               int(ErrorKind::usage), {"refers to files beside it", "bark.png"});
}

TEST_CASE("a .glb embeds images from data URIs") {
  const Workplace workplace;
  const std::string moss = bake(workplace, workplace.write("moss.png", smooth(8)), "moss.glb");
  example::TinyScene scene = example::tableScene();
  scene.json["images"] = {{{"uri", "data:image/png;base64," + kDot}}};
  workplace.write("scene.bin", scene.binary);
  const std::string path = workplace.write("scene.gltf", scene.gltf("scene.bin"));
  REQUIRE(apply(workplace, path, moss, "wood").code == 0);
  const json image = GltfScene::open(workplace.path("out.glb")).value().document()["images"][0];
  CHECK(!image.contains("uri"));
  CHECK(image["mimeType"] == "image/png");
  CHECK(image.contains("bufferView"));
}
