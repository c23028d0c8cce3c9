// SPDX-License-Identifier: MIT
// `lichen apply`: the scene it writes for a scene and a noise.
#include "apply_run.h"
#include "bundle_example.h"

#include <lichen/bundle.h>
#include <lichen/bundle_writer.h>
#include <lichen/files.h>
#include <lichen/gltf_scene.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iomanip>
#include <sstream>

using namespace lichen;
using namespace lichen::cli_test;
using nlohmann::json;

TEST_CASE("apply adds the noise to one material and leaves all others unchanged") {
  const Workplace workplace;
  const std::string moss = bake(workplace, workplace.write("moss.png", smooth(16)), "moss.glb",
                                {"--seed", "7", "--tile", "2"});
  const example::TinyScene scene = example::tableScene();
  const json document =
      applied(workplace, writeScene(workplace, scene), moss, "wood", {"--scale", "0.5"});
  const json use{{"noise", 0}, {"scale", 0.5}, {"seed", 7}};
  CHECK(document["materials"][0]["extensions"][kExtension] == use);
  CHECK(document["materials"][0]["pbrMetallicRoughness"] ==
        json(scene.json["materials"][0]["pbrMetallicRoughness"]));
  CHECK(document["materials"][1] == json(scene.json["materials"][1]));
  CHECK(document["meshes"] == json(scene.json["meshes"]));
  CHECK(document["nodes"] == json(scene.json["nodes"]));
  CHECK(document["extensionsUsed"] == json{kExtension});
  const Bundle bundle = readBundle(workplace.path("out.glb")).value();
  CHECK(bundle.noises[0].name == "moss");
  CHECK(bundle.noises[0].tileSizeMetres == 2.0);
  CHECK(bundle.tables[0].texels == readBundle(moss).value().tables[0].texels);
}

TEST_CASE("materials are given by name, by index or as all") {
  const Workplace workplace;
  const std::string wool = writeTexton(workplace);
  example::TinyScene scene = example::tableScene();
  const auto uses = [&](const std::string& material) {
    const json document = applied(workplace, writeScene(workplace, scene), wool, material,
                                  {"--mapping", "triplanar"});
    std::string which;
    for (const json& each : document["materials"])
      which += each.contains("extensions") ? "x" : "-";
    return which;
  };
  CHECK(uses("wood") == "x-");
  CHECK(uses("1") == "-x");
  CHECK(uses("all") == "xx");
  scene.json["materials"][0]["name"] = "1"; // names take precedence over indices
  CHECK(uses("1") == "x-");
  scene.json["materials"][1]["name"] = "1";
  const std::string path = writeScene(workplace, scene);
  const std::string output = workplace.path("none.glb");
  const int usage = int(ErrorKind::usage);
  const auto refused = [&](const std::string& material, const std::vector<std::string>& words) {
    checkRefusal({"apply", path, "--noise", wool, "--material", material, "--mapping", "triplanar",
                  "-o", output},
                 usage, words);
  };
  refused("1", {"--material 1", "0, 1", "index"});
  refused("marble", {"--material marble", "0 '1', 1 '1'"});
  refused("2", {"--material 2"});
  refused("-1", {"--material -1"});
  CHECK(!std::filesystem::exists(output));
}

TEST_CASE("--material may be repeated, and names may contain commas") {
  const Workplace workplace;
  const std::string wool = writeTexton(workplace);
  example::TinyScene scene = example::tableScene();
  scene.json["materials"][0]["name"] = "oak, oiled";
  scene.json["materials"].push_back({{"name", "third"}});
  const std::string path = writeScene(workplace, scene);
  const json document = applied(workplace, path, wool, "third",
                                {"--material", "oak, oiled", "--mapping", "triplanar"});
  CHECK(document["materials"][0].contains("extensions"));
  CHECK(!document["materials"][1].contains("extensions"));
  CHECK(document["materials"][2].contains("extensions"));
  checkRefusal({"apply", path, "--noise", wool, "--material", "all", "--material", "third", "-o",
                workplace.path("x.glb")},
               int(ErrorKind::usage), {"--material all"});
}

TEST_CASE("--material all skips materials without texture coordinates, with a note") {
  const Workplace workplace;
  const std::string wool = writeTexton(workplace);
  example::TinyScene scene = example::tableScene();
  const std::string path = writeScene(workplace, scene);
  const Ended ended = apply(workplace, path, wool, "all");
  REQUIRE(ended.code == 0);
  CHECK_THAT(ended.errors,
             Catch::Contains("skipped material 'glass': primitive 1 of mesh 'table' has no") &&
                 Catch::Contains("TEXCOORD_0") && Catch::Contains("use --mapping triplanar there"));
  const json document = GltfScene::open(workplace.path("out.glb")).value().document();
  CHECK(document["materials"][0].contains("extensions"));
  CHECK(!document["materials"][1].contains("extensions"));
  checkRefusal({"apply", path, "--noise", wool, "--material", "wood", "--material", "glass", "-o",
                workplace.path("x.glb")},
               int(ErrorKind::badInput), {"material 'glass'", "TEXCOORD_0"});
  scene.json["meshes"][0]["primitives"][0]["attributes"].erase("TEXCOORD_0");
  checkRefusal({"apply", writeScene(workplace, scene), "--noise", wool, "--material", "all", "-o",
                workplace.path("x.glb")},
               int(ErrorKind::badInput), {"material 'wood'", "TEXCOORD_0"});
}

TEST_CASE("the name of a noise follows its bundle after a colon") {
  const Workplace workplace;
  const std::string grey = workplace.write("grey.png", smoothGrey(8));
  const std::string first = bake(workplace, grey, "first.glb", {"--name", "one"});
  const std::string second = bake(workplace, grey, "second.glb", {"--name", "two", "--tile", "3"});
  REQUIRE(runLichen({"merge", first, second, "-o", workplace.path("b:th.glb"), "--preview", "none"})
              .code == 0);
  const std::string scene = writeScene(workplace, example::tableScene());
  const auto nameOfNoise = [&](const std::string& noise) {
    return applied(workplace, scene, workplace.path(noise),
                   "0")["extensions"][kExtension]["noises"][0]["name"];
  };
  CHECK(nameOfNoise("b:th.glb") == "one"); // the file name itself contains a colon
  CHECK(nameOfNoise("b:th.glb:two") == "two");
  checkRefusal({"apply", scene, "--noise", workplace.path("b:th.glb:three"), "--material", "0",
                "-o", workplace.path("x.glb")},
               int(ErrorKind::usage), {"three", "expected one or two"});
  checkRefusal({"apply", scene, "--noise", workplace.path("b:th.glb:"), "--material", "0", "-o",
                workplace.path("x.glb")},
               int(ErrorKind::usage), {"b:th.glb::", "empty"});
}

TEST_CASE("the error for a mapping that the method or the meshes do not support names it") {
  const Workplace workplace;
  const std::string moss = bake(workplace, workplace.write("moss.png", smoothGrey(8)), "moss.glb");
  const std::string wool = writeTexton(workplace);
  example::TinyScene scene = example::tableScene();
  const int usage = int(ErrorKind::usage), bad = int(ErrorKind::badInput);
  const auto refused = [&](const std::string& noise, const std::string& mapping,
                           const std::string& material, int code,
                           const std::vector<std::string>& words) {
    checkRefusal({"apply", writeScene(workplace, scene), "--noise", noise, "--material", material,
                  "--mapping", mapping, "-o", workplace.path("x.glb")},
                 code, words);
  };
  refused(moss, "surface", "0", usage, {"--mapping surface", "tiling", "uv or triplanar"});
  refused(wool, "solid", "0", usage,
          {"--mapping solid", "texton", "uv, triplanar or surface", "--method local-random-phase"});
  const std::string bricks = workplace.path("bricks.glb");
  REQUIRE(writeBundle(bricks, example::smallestStructure()).ok());
  refused(bricks, "solid", "0", usage, {"--mapping solid", "structure", "--structure 0"});
  refused(moss, "uv", "glass", bad,
          {"primitive 1 of mesh 'table'", "material 'glass'", "TEXCOORD_0"});
  scene.json["materials"][0]["normalTexture"] = {{"index", 0}};
  refused(wool, "surface", "0", bad, {"primitive 0", "TANGENT", "normalTexture"});
  scene.json["meshes"][0]["primitives"][1]["mode"] = 3;
  refused(wool, "surface", "glass", bad, {"primitive 1 of mesh 'table'", "lines"});
  CHECK(!std::filesystem::exists(workplace.path("x.glb")));
}

TEST_CASE("a broken mesh is an error if it gets the noise, else a note") {
  const Workplace workplace;
  const std::string wool = writeTexton(workplace);
  const auto refused = [&](const example::TinyScene& scene, const std::vector<std::string>& words) {
    const std::string path = writeScene(workplace, scene);
    for (const char* mapping : {"uv", "triplanar"})
      checkRefusal({"apply", path, "--noise", wool, "--material", "wood", "--mapping", mapping,
                    "-o", workplace.path("x.glb")},
                   int(ErrorKind::badInput), words);
    const Ended other = apply(workplace, path, wool, "glass", {"--mapping", "triplanar"});
    CHECK(other.code == 0); // the faulty primitive stays as it is
    CHECK_THAT(other.errors,
               Catch::Contains(words.back()) && Catch::Contains("it is without noise"));
  };
  const example::TinyScene sound = example::tableScene();
  const auto attributeOf = [](example::TinyScene & scene) -> auto& {
    return scene.json["meshes"][0]["primitives"][0]["attributes"];
  };
  example::TinyScene scene = sound;
  const std::vector<std::uint16_t> outside{0, 1, 4};
  scene.json["meshes"][0]["primitives"][0]["indices"] =
      scene.addAccessor(outside, "SCALAR", 5123, 1);
  refused(scene,
          {"primitive 0 of mesh 'table'", "/accessors/", "index 4; expected an index below 4"});
  for (const auto& [name, components] : {std::pair{"POSITION", 3}, std::pair{"TEXCOORD_0", 2}}) {
    scene = sound;
    const std::vector<float> values(std::size_t(4 * components), std::nanf(""));
    const char* type = components == 3 ? "VEC3" : "VEC2";
    attributeOf(scene)[name] = scene.addFloats(values, type, std::size_t(components));
    refused(scene, {"primitive 0 of mesh 'table'", "/accessors/", "NaN"});
    scene = sound;
    const std::vector<float> four(std::size_t(4 * 4));
    attributeOf(scene)[name] = scene.addFloats(four, "VEC4", 4);
    refused(scene, {"primitive 0 of mesh 'table'", "/accessors/", std::string("not ") + type});
  }
  scene = sound;
  attributeOf(scene)["TEXCOORD_0"] = scene.addFloats({0, 0, 1, 1}, "VEC2", 2);
  refused(scene, {"primitive 0 of mesh 'table'", "2 texture coordinates for 4 positions"});
  scene = sound;
  scene.json["meshes"][0]["primitives"][0]["mode"] = 7;
  refused(scene, {"primitive 0 of mesh 'table'", "mode 7; expected 0 to 6"});
  CHECK(!std::filesystem::exists(workplace.path("x.glb")));
}

TEST_CASE("the error for a material that is not valid glTF states its JSON pointer") {
  const Workplace workplace;
  const std::string wool = writeTexton(workplace);
  const auto refused = [&](const char* member, const json& value, const char* named) {
    example::TinyScene scene = example::tableScene();
    scene.json["materials"][0][member] = value;
    checkRefusal({"apply", writeScene(workplace, scene), "--noise", wool, "--material", "wood",
                  "-o", workplace.path("x.glb")},
                 int(ErrorKind::badInput), {named});
  };
  refused("pbrMetallicRoughness", json::array(), "/materials/0/pbrMetallicRoughness");
  refused("pbrMetallicRoughness", json{{"baseColorTexture", 1}}, "baseColorTexture");
  refused("normalTexture", json{{"scale", 1}}, "/materials/0/normalTexture");
  refused("emissiveTexture", json{{"index", 0}, {"extensions", {{"KHR_texture_transform", "no"}}}},
          "/materials/0/emissiveTexture/extensions");
}

TEST_CASE("compressed meshes get the noise, with a note") {
  const Workplace workplace;
  const std::string wool = writeTexton(workplace);
  const example::TinyScene sound = example::tableScene();
  const auto noted = [&](const example::TinyScene& scene, const std::string& extension) {
    const Ended ended = apply(workplace, writeScene(workplace, scene), wool, "wood");
    CHECK(ended.code == 0);
    CHECK_THAT(ended.errors, Catch::Contains("primitive 0 of mesh 'table'") &&
                                 Catch::Contains(extension) &&
                                 Catch::Contains("lichen-render does not read"));
  };
  example::TinyScene scene = sound;
  scene.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {
      {"bufferView", 0}, {"attributes", {{"POSITION", 0}}}};
  noted(scene, "KHR_draco_mesh_compression");
  scene = sound;
  const std::size_t position = scene.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"];
  const std::size_t view = scene.json["accessors"][position]["bufferView"];
  scene.json["bufferViews"][view]["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0}};
  noted(scene, "EXT_meshopt_compression");
  scene = sound; // a sparse accessor
  const std::size_t values = scene.addView(std::as_bytes(std::span<const float>()));
  scene.json["bufferViews"][values]["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0}};
  scene.json["accessors"][position]["sparse"]["values"]["bufferView"] = values;
  noted(scene, "EXT_meshopt_compression");
}

TEST_CASE("the report lists frames, singularities and factors that multiply the noise") {
  const Workplace workplace;
  const std::string wool = writeTexton(workplace);
  const std::string scene = writeScene(workplace, example::tableScene());
  const Ended ended = apply(workplace, scene, wool, "glass", {"--mapping", "surface", "--json"});
  REQUIRE(ended.code == 0);
  CHECK(ended.errors.empty());
  const json report = json::parse(ended.output);
  CHECK(report["noise"] == "wool");
  CHECK(report["newTables"] == 1);
  CHECK(report["materials"] == json{"material 'glass'"});
  const json& frames = report["frames"][0];
  CHECK(frames["mesh"] == "mesh 'table'");
  CHECK(frames["triangles"] == 4);
  CHECK(frames["newNormals"] == true);
  CHECK(frames["components"][0]["closed"] == true);
  CHECK(frames["components"][0]["eulerCharacteristic"] == 2);
  int sum = 0;
  for (const json& singularity : frames["singularities"])
    sum += singularity["index"].get<int>();
  CHECK(sum == 2);
  CHECK(report["notes"].size() == 2);
  std::ostringstream place; // three digits, as the note prints
  place << std::setprecision(3) << '(' << frames["singularities"][0]["position"][0].get<double>();
  CHECK_THAT(apply(workplace, scene, wool, "glass", {"--mapping", "surface"}).errors,
             Catch::Contains("singular triangle") && Catch::Contains(place.str()));

  const std::string moss = bake(workplace, workplace.write("moss.png", smooth(8)), "moss.glb");
  const Ended noted = apply(workplace, scene, moss, "wood");
  CHECK_THAT(noted.errors, Catch::Contains("baseColorFactor [0.5,0.25,0.125,1]") &&
                               Catch::Contains("material 'wood'"));
  CHECK(apply(workplace, scene, moss, "wood", {"--quiet"}).errors.empty());
}

TEST_CASE("factors are kept or set to 1, and one note lists those of many materials") {
  const Workplace workplace;
  const std::string moss = bake(workplace, workplace.write("moss.png", smooth(8)), "moss.glb");
  example::TinyScene scene = example::tableScene();
  auto& materials = scene.json["materials"];
  materials[0]["pbrMetallicRoughness"]["baseColorFactor"] = {0.800000011920929, 0, 0, 0.51};
  materials[1]["pbrMetallicRoughness"]["baseColorFactor"] = {0.05, 0.09, 0, 1};
  for (int more = 0; more < 6; ++more)
    materials.push_back({{"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.5, 0.5, 1}}}}});
  const std::string path = writeScene(workplace, scene);
  const Arguments triplanar{"--mapping", "triplanar"};
  const Ended kept = apply(workplace, path, moss, "all", triplanar);
  REQUIRE(kept.code == 0);
  CHECK_THAT(kept.errors,
             Catch::Contains("baseColorFactor [0.8,0,0,0.51] of material 'wood', baseColorFactor "
                             "[0.5,0.5,0.5,1] of material 2,") &&
                 Catch::Contains("and 3 others multiply the noise") &&
                 Catch::Contains("--factors one") &&
                 Catch::Contains("[0.05,0.09,0,1] of material 'glass' is below 0.1"));
  CHECK_THAT(kept.errors, Catch::Contains("the size of a tile is unknown on material 2,"));
  CHECK(std::count(kept.errors.begin(), kept.errors.end(), '\n') == 3);
  const json document =
      applied(workplace, path, moss, "all", {"--mapping", "triplanar", "--factors", "one"});
  const auto factorOf = [&](std::size_t material) {
    return document["materials"][material]["pbrMetallicRoughness"]["baseColorFactor"];
  };
  CHECK(factorOf(0) == json{1.0, 1.0, 1.0, 0.51});
  CHECK(factorOf(1) == json{1.0, 1.0, 1.0, 1.0});
  CHECK(factorOf(7) == json{1.0, 1.0, 1.0, 1.0});
  CHECK(
      apply(workplace, path, moss, "all", {"--mapping", "triplanar", "--factors", "one", "--quiet"})
          .errors.empty());
  checkRefusal({"apply", path, "--noise", moss, "--material", "0", "--factors", "2", "-o",
                workplace.path("x.glb")},
               int(ErrorKind::usage), {"--factors 2", "keep or one"});
}

TEST_CASE("setting an emissive factor to 1 without a texture gives a note") {
  const Workplace workplace;
  std::filesystem::create_directory(workplace.path("set"));
  for (const char* map : {"set/diff.png", "set/emissive.png"})
    workplace.write(map, smooth(8));
  const std::string glow = bake(workplace, workplace.path("set"), "glow.glb");
  example::TinyScene scene = example::tableScene();
  const auto noted = [&] {
    const Ended ended =
        apply(workplace, writeScene(workplace, scene), glow, "wood", {"--factors", "one"});
    CHECK(ended.code == 0);
    return ended.errors.find("emissiveFactor of material 'wood' is 1 without") != std::string::npos;
  };
  CHECK(noted());
  scene.json["materials"][0]["emissiveFactor"] = {1.0, 1.0, 1.0};
  CHECK_FALSE(noted()); // it was emissive before
}

TEST_CASE("a note names the textures for which the noise has no map") {
  const Workplace workplace;
  const std::string moss = bake(workplace, workplace.write("moss.png", smooth(8)), "moss.glb");
  example::TinyScene scene = example::tableScene();
  scene.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
  scene.json["materials"][0]["pbrMetallicRoughness"]["metallicRoughnessTexture"] = {{"index", 0}};
  scene.json["materials"][0]["normalTexture"] = {{"index", 0}};
  const Ended ended = apply(workplace, writeScene(workplace, scene), moss, "wood");
  REQUIRE(ended.code == 0);
  CHECK_THAT(ended.errors,
             Catch::Contains("normalTexture of material 'wood', "
                             "metallicRoughnessTexture of material 'wood' stay "
                             "visible: the noise has no such map, or not all its channels"));
  CHECK_THAT(ended.errors, !Catch::Contains("baseColorTexture"));
}

TEST_CASE("quarter turns of tiles that are not square are an error, and half turns are not") {
  const Workplace workplace;
  const std::string plank =
      bake(workplace, workplace.write("plank.png", speckled(16, 8, 3)), "plank.glb");
  const std::string scene = writeScene(workplace, example::tableScene());
  const auto applyTurned = [&](const std::string& angles) {
    return Arguments{"apply",
                     scene,
                     "--noise",
                     plank,
                     "--material",
                     "wood",
                     "--tile-rotation",
                     angles,
                     "-o",
                     workplace.path("out.glb")};
  };
  checkRefusal(applyTurned("4"), int(ErrorKind::usage),
               {"--tile-rotation 4", "'plank'", "not square", "none or 2"});
  checkRefusal({"synth", plank, "-o", workplace.path("new.png"), "--tile-rotation", "4"},
               int(ErrorKind::usage),
               {"tile rotation 4", "'plank'", "0, 1, 2, or 4 if tiles are square"});
  CHECK(runLichen(applyTurned("2")).code == 0);
}

TEST_CASE("a noise applied twice is stored once, under its name") {
  const Workplace workplace;
  const std::string wool = writeTexton(workplace);
  const std::string scene = writeScene(workplace, example::tableScene());
  const Arguments triplanar{"--mapping", "triplanar"};
  const json once = applied(workplace, scene, wool, "0", triplanar);
  const json twice = applied(workplace, workplace.path("out.glb"), wool, "1", triplanar);
  CHECK(twice["bufferViews"] == once["bufferViews"]);
  CHECK(twice["extensions"] == once["extensions"]);
  const std::string moss =
      bake(workplace, workplace.write("moss.png", smooth(8)), "moss.glb", {"--name", "wool"});
  const Ended ended = apply(workplace, workplace.path("out.glb"), moss, "0");
  CHECK(ended.code == 0);
  CHECK_THAT(ended.errors, Catch::Contains("'wool-2'"));
}

TEST_CASE("the options set every parameter that needs no new bake") {
  const Workplace workplace;
  const std::string moss = bake(workplace, workplace.write("moss.png", smooth(8)), "moss.glb");
  const std::string scene = writeScene(workplace, example::tableScene());
  static_cast<void>(applied(workplace, scene, moss, "0",
                            {"--scale", "2", "--rotation", "90", "--seed", "7", "--contrast", "0.5",
                             "--sharpness", "4", "--tile-rotation", "4"}));
  const MaterialNoise use = *readBundle(workplace.path("out.glb")).value().materials[0];
  CHECK(use.scale == 2.0);
  CHECK(use.rotation == Approx(1.5707963267948966).epsilon(1e-12)); // 90 degrees, in radians
  CHECK(use.seed == 7);
  CHECK(use.contrast == 0.5);
  CHECK(use.blendSharpness == 4.0);
  CHECK(use.tileRotation == 4);
}

TEST_CASE("an option that the noise's method or the mapping does not have is an error") {
  const Workplace workplace;
  const std::string wool = writeTexton(workplace);
  const std::string scene = writeScene(workplace, example::tableScene());
  const auto refused = [&](const std::string& option, const std::string& value,
                           const std::vector<std::string>& words) {
    checkRefusal({"apply", scene, "--noise", wool, "--material", "0", option, value, "-o",
                  workplace.path("x.glb")},
                 int(ErrorKind::usage), words);
  };
  refused("--sharpness", "2", {"--sharpness", "'wool'", "texton", "tiling"});
  refused("--tile-rotation", "4", {"--tile-rotation", "'wool'", "texton", "tiling"});
  refused("--plane-sharpness", "2", {"--plane-sharpness", "uv", "--mapping triplanar"});
}

TEST_CASE("--plane-sharpness sets the sharpness of the planes") {
  const Workplace workplace;
  const std::string wool = writeTexton(workplace);
  const std::string scene = writeScene(workplace, example::tableScene());
  const json document =
      applied(workplace, scene, wool, "0", {"--mapping", "triplanar", "--plane-sharpness", "4"});
  CHECK(document["materials"][0]["extensions"][kExtension]["planeSharpness"] == 4.0);
  CHECK(readBundle(workplace.path("out.glb")).value().materials[0]->planeSharpness == 4.0);
}

TEST_CASE("the space comes from the option, else from the bundle, and inspect shows it") {
  const Workplace workplace;
  const std::string wool = writeTexton(workplace);
  const std::string scene = writeScene(workplace, example::tableScene());
  const auto spaceIn = [](const json& document) {
    return document["materials"][0]["extensions"][kExtension].value("space", "none");
  };
  const json inObject =
      applied(workplace, scene, wool, "0", {"--mapping", "triplanar", "--space", "object"});
  CHECK(spaceIn(inObject) == "object");
  const std::string made = workplace.path("object.glb");
  std::filesystem::rename(workplace.path("out.glb"), made);
  CHECK(readBundle(made).value().materials[0]->space == NoiseSpace::object);
  CHECK_THAT(runLichen({"inspect", made}).output,
             Catch::Contains("triplanar in object space, seed"));
  CHECK(json::parse(runLichen({"inspect", made, "--json"}).output)
            .at(json::json_pointer("/noises/0/materials/0/space")) == "object");
  CHECK(spaceIn(applied(workplace, scene, made, "0", {"--mapping", "triplanar"})) == "object");
  CHECK(spaceIn(applied(workplace, scene, made, "0",
                        {"--mapping", "triplanar", "--space", "world"})) == "none");
  CHECK(spaceIn(applied(workplace, scene, made, "0")) == "none"); // with the mapping uv
  checkRefusal({"apply", scene, "--noise", wool, "--material", "0", "--space", "object", "-o",
                workplace.path("x.glb")},
               int(ErrorKind::usage),
               {"--space object", "uv", "--mapping triplanar, surface or solid"});
}

TEST_CASE("the same call writes the same bytes") {
  const Workplace workplace;
  const std::string wool = writeTexton(workplace);
  const std::string scene = writeScene(workplace, example::tableScene());
  for (const char* name : {"a.glb", "b.glb"})
    REQUIRE(apply(workplace, scene, wool, "all",
                  {"--mapping", "surface", "--threads", name[0] == 'a' ? "1" : "4"}, name)
                .code == 0);
  CHECK(workplace.read("a.glb") == workplace.read("b.glb"));
}

TEST_CASE("unusable scenes, noises and outputs are errors and leave no file") {
  const Workplace workplace;
  const std::string wool = writeTexton(workplace);
  const std::string scene = writeScene(workplace, example::tableScene());
  const std::string image = workplace.write("image.png", smooth(8));
  const std::string empty = workplace.write("empty.gltf", R"({"asset":{"version":"2.0"}})");
  const std::string twice = workplace.write(
      "twice.gltf", R"({"asset":{"version":"2.0"},"materials":[{}],"materials":[{}]})");
  const std::string output = workplace.path("x.glb");
  const int bad = int(ErrorKind::badInput), usage = int(ErrorKind::usage);
  const auto refused = [&](const std::string& from, const std::string& noise, const std::string& to,
                           int code, const std::vector<std::string>& words) {
    checkRefusal(
        {"apply", from, "--noise", noise, "--material", "0", "--mapping", "triplanar", "-o", to},
        code, words);
  };
  refused(image, wool, output, bad, {"image.png"});
  refused(workplace.path("none.glb"), wool, output, bad, {"none.glb"});
  refused(scene, image, output, bad, {"image.png"});
  refused(scene, scene, output, bad, {"scene.glb", "no noise"});
  refused(empty, wool, output, bad, {"empty.gltf", "no materials"});
  refused(twice, wool, output, bad, {"twice.gltf", "two members \"materials\""});
  refused(scene, wool, workplace.path("x.png"), usage, {".glb", ".gltf"});
  refused(scene, wool, workplace.path("none/x.glb"), int(ErrorKind::environment), {"none"});
  checkRefusal({"apply", scene, "--noise", wool, "-o", output}, usage, {"--material is required"});
  checkRefusal({"apply", scene, "--noise", wool, "--material", "0", "--scale", "0", "-o", output},
               usage, {"--scale 0"});
  checkRefusal(
      {"apply", scene, "--noise", wool, "--material", "0", "--plane-sharpness", "65", "-o", output},
      usage, {"--plane-sharpness 65", "1", "64"});
  CHECK(!std::filesystem::exists(output));
}
