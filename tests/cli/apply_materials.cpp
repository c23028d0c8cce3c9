// SPDX-License-Identifier: MIT
// `lichen apply` on materials with more features than a noise replaces.
#include "apply_run.h"

#include <lichen/gltf_scene.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace lichen;
using namespace lichen::cli_test;
using nlohmann::json;

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
  CHECK_THAT(ended.errors, Catch::Contains("/images/0: the file 'old%20bark.png' is missing, "
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

TEST_CASE("materials whose shading ignores a noise are skipped by all and an error by name") {
  const Workplace workplace;
  const std::string moss = bake(workplace, workplace.write("moss.png", smooth(8)), "moss.glb");
  for (const char* extension : {"KHR_materials_unlit", "KHR_materials_pbrSpecularGlossiness"}) {
    example::TinyScene scene = example::tableScene();
    scene.json["extensionsUsed"] = json::array({extension});
    scene.json["materials"][1]["extensions"][extension] = json::object();
    const std::string path = writeScene(workplace, scene);
    const Ended ended = apply(workplace, path, moss, "all", {"--mapping", "triplanar"});
    REQUIRE(ended.code == 0);
    CHECK_THAT(ended.errors,
               Catch::Contains("skipped material 'glass': it has " + std::string(extension)));
    const json document = GltfScene::open(workplace.path("out.glb")).value().document();
    CHECK(document["materials"][0]["extensions"].contains(kExtension));
    CHECK(!document["materials"][1]["extensions"].contains(kExtension));
    checkRefusal({"apply", path, "--noise", moss, "--material", "glass", "--mapping", "triplanar",
                  "-o", workplace.path("x.glb")},
                 int(ErrorKind::badInput),
                 {"material 'glass' has", extension, "choose a material without that extension"});
    scene.json["materials"][0]["extensions"][extension] = json::object();
    checkRefusal({"apply", writeScene(workplace, scene), "--noise", moss, "--material", "all",
                  "--mapping", "triplanar", "-o", workplace.path("x.glb")},
                 int(ErrorKind::badInput), {"material 'wood' has", extension});
  }
}

TEST_CASE("a .glb embeds images from data URIs") {
  const Workplace workplace;
  const std::string moss = bake(workplace, workplace.write("moss.png", smooth(8)), "moss.glb");
  example::TinyScene scene = example::tableScene();
  const std::string dot = // a PNG of one pixel
      "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGP4z8AAAAMBAQDJ/"
      "pLvAAAAAElFTkSuQmCC";
  scene.json["images"] = {{{"uri", "data:image/png;base64," + dot}}};
  workplace.write("scene.bin", scene.binary);
  const std::string path = workplace.write("scene.gltf", scene.gltf("scene.bin"));
  REQUIRE(apply(workplace, path, moss, "wood").code == 0);
  const json image = GltfScene::open(workplace.path("out.glb")).value().document()["images"][0];
  CHECK(!image.contains("uri"));
  CHECK(image["mimeType"] == "image/png");
  CHECK(image.contains("bufferView"));
}
