// SPDX-License-Identifier: MIT
// `lichen apply`: the scene it writes for a scene and a noise.
#include "apply_run.h"
#include "bundle_example.h"

#include <lichen/bundle_files.h>
#include <lichen/bundle_writer.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <sstream>

using namespace lichen;
using namespace lichen::cli_test;
using nlohmann::json;

namespace {

const Arguments kTriplanar{"--mapping", "triplanar"};
const Arguments kSurface{"--mapping", "surface"};

MaterialNoise firstUse(const Apply& apply) {
  return *readBundle(apply.workplace.path("out.glb")).value().materials[0];
}

} // namespace

TEST_CASE("apply adds the noise to one material and leaves all others unchanged") {
  Apply apply;
  const std::string own = bake(apply.workplace, apply.workplace.write("moss.png", smooth(16)),
                               "moss.glb", {"--seed", "7", "--tile", "2"});
  const json document = apply.document(own, "wood", {"--scale", "0.5"});
  const json use{{"noise", 0}, {"scale", 0.5}, {"seed", 7}};
  CHECK(document["materials"][0]["extensions"][kExtension] == use);
  CHECK(document["materials"][0]["pbrMetallicRoughness"] ==
        json(apply.material()["pbrMetallicRoughness"]));
  CHECK(document["materials"][1] == json(apply.material(1)));
  CHECK(document["meshes"] == json(apply.scene.json["meshes"]));
  CHECK(document["nodes"] == json(apply.scene.json["nodes"]));
  CHECK(document["extensionsUsed"] == json{kExtension});
  const Bundle bundle = readBundle(apply.workplace.path("out.glb")).value();
  CHECK(bundle.noises[0].name == "moss");
  CHECK(bundle.noises[0].tileSizeMetres == 2.0);
  CHECK(bundle.tables[0].texels == readBundle(own).value().tables[0].texels);
}

TEST_CASE("materials are given by name, by index or as all, and --material may be repeated") {
  Apply apply;
  const auto uses = [&](const std::string& material, const Arguments& more = {}) {
    const json document = apply.document(wool(), material, kTriplanar + more);
    std::string which;
    for (const json& each : document["materials"])
      which += each.contains("extensions") ? "x" : "-";
    return which;
  };
  CHECK(uses("wood") == "x-");
  CHECK(uses("1") == "-x");
  CHECK(uses("all") == "xx");
  apply.material()["name"] = "1"; // names take precedence over indices
  CHECK(uses("1") == "x-");
  apply.material(1)["name"] = "1";
  apply.refuses(wool(), "1", kTriplanar, {"--material 1", "0, 1", "index"});
  apply.refuses(wool(), "marble", kTriplanar, {"--material marble", "0 '1', 1 '1'"});
  apply.refuses(wool(), "2", kTriplanar, {"--material 2"});
  apply.refuses(wool(), "-1", kTriplanar, {"--material -1"});
  apply.material()["name"] = "oak, oiled"; // names may contain commas
  apply.scene.json["materials"].push_back({{"name", "third"}});
  CHECK(uses("third", {"--material", "oak, oiled"}) == "x-x");
  apply.refuses(wool(), "all", {"--material", "third"}, {"--material all"});
}

TEST_CASE("--material all skips materials without texture coordinates, with a note") {
  Apply apply;
  CHECK_THAT(apply.notes(wool(), "all"),
             Catch::Contains("skipped material 'glass': primitive 1 of mesh 'table' has no") &&
                 Catch::Contains("TEXCOORD_0") && Catch::Contains("use --mapping triplanar there"));
  const json document = apply.output();
  CHECK(document["materials"][0].contains("extensions"));
  CHECK(!document["materials"][1].contains("extensions"));
  apply.refuses(wool(), "wood", {"--material", "glass"}, {"material 'glass'", "TEXCOORD_0"},
                kBadInput);
  apply.primitive()["attributes"].erase("TEXCOORD_0");
  apply.refuses(wool(), "all", {}, {"material 'wood'", "TEXCOORD_0"}, kBadInput);
}

TEST_CASE("the name of a noise follows its bundle after a colon") {
  Apply apply;
  const Workplace& workplace = apply.workplace;
  const std::string grey = workplace.write("grey.png", smoothGrey(8));
  const std::string first = bake(workplace, grey, "first.glb", {"--name", "one"});
  const std::string second = bake(workplace, grey, "second.glb", {"--name", "two", "--tile", "3"});
  succeed({"merge", first, second, "-o", workplace.path("b:th.glb"), "--preview", "none"});
  const auto nameOfNoise = [&](const std::string& noise) {
    return apply.document(workplace.path(noise),
                          "0")["extensions"][kExtension]["noises"][0]["name"];
  };
  CHECK(nameOfNoise("b:th.glb") == "one"); // the file name itself contains a colon
  CHECK(nameOfNoise("b:th.glb:two") == "two");
  apply.refuses(workplace.path("b:th.glb:three"), "0", {}, {"three", "expected one or two"});
  apply.refuses(workplace.path("b:th.glb:"), "0", {}, {"b:th.glb::", "empty"});
}

TEST_CASE("the error for a mapping that the method or the meshes do not support names it") {
  Apply apply;
  const Arguments solid{"--mapping", "solid"};
  apply.refuses(moss(), "0", kSurface, {"--mapping surface", "tiling", "uv or triplanar"});
  apply.refuses(
      wool(), "0", solid,
      {"--mapping solid", "texton", "uv, triplanar or surface", "--method local-random-phase"});
  const std::string bricks = apply.workplace.path("bricks.glb");
  REQUIRE(writeBundle(bricks, example::smallestStructure()).ok());
  apply.refuses(bricks, "0", solid, {"--mapping solid", "structure", "--structure 0"});
  apply.refuses(moss(), "glass", {},
                {"primitive 1 of mesh 'table'", "material 'glass'", "TEXCOORD_0"}, kBadInput);
  apply.material()["normalTexture"] = {{"index", 0}};
  apply.refuses(wool(), "0", kSurface, {"primitive 0", "TANGENT", "normalTexture"}, kBadInput);
  apply.primitive(1)["mode"] = 3;
  apply.refuses(wool(), "glass", kSurface, {"primitive 1 of mesh 'table'", "lines"}, kBadInput);
}

// The reader's tests have every fault of a mesh.
TEST_CASE("a broken mesh is an error if it gets the noise, else a note") {
  struct Fault {
    std::function<void(Apply&)> breakIt;
    std::string words;
  };
  const Fault faults[] = {
      {[](Apply& a) {
         a.primitive()["indices"] =
             a.scene.addAccessor(std::vector<std::uint16_t>{0, 1, 4}, "SCALAR", 5123, 1);
       },
       "index 4; expected an index below 4"},
      {[](Apply& a) {
         a.primitive()["attributes"]["TEXCOORD_0"] =
             a.scene.addFloats(std::vector<float>(8, std::nanf("")), "VEC2", 2);
       },
       "NaN"},
      {[](Apply& a) {
         a.primitive()["attributes"]["TEXCOORD_0"] = a.scene.addFloats({0, 0, 1, 1}, "VEC2", 2);
       },
       "2 texture coordinates for 4 positions"},
      {[](Apply& a) { a.primitive()["mode"] = 7; }, "mode 7; expected 0 to 6"}};
  for (const Fault& fault : faults) {
    Apply apply;
    fault.breakIt(apply);
    for (const char* mapping : {"uv", "triplanar"})
      apply.refuses(wool(), "wood", {"--mapping", mapping},
                    {"primitive 0 of mesh 'table'", fault.words}, kBadInput);
    CHECK_THAT(apply.notes(wool(), "glass", kTriplanar), // the faulty primitive stays as it is
               Catch::Contains(fault.words) && Catch::Contains("it is without noise"));
  }
}

TEST_CASE("the error for a material that is not valid glTF states its JSON pointer") {
  const std::tuple<const char*, json, const char*> faults[] = {
      {"pbrMetallicRoughness", json::array(), "/materials/0/pbrMetallicRoughness"},
      {"pbrMetallicRoughness", json{{"baseColorTexture", 1}}, "baseColorTexture"},
      {"normalTexture", json{{"scale", 1}}, "/materials/0/normalTexture"},
      {"emissiveTexture", json{{"index", 0}, {"extensions", {{"KHR_texture_transform", "no"}}}},
       "/materials/0/emissiveTexture/extensions"}};
  for (const auto& [member, value, named] : faults) {
    Apply apply;
    apply.material()[member] = value;
    apply.refuses(wool(), "wood", {}, {named}, kBadInput);
  }
}

TEST_CASE("compressed meshes get the noise, with a note") {
  const auto noted = [](const Apply& apply, const std::string& extension) {
    CHECK_THAT(apply.notes(wool(), "wood"), Catch::Contains("primitive 0 of mesh 'table'") &&
                                                Catch::Contains(extension) &&
                                                Catch::Contains("lichen-render does not read"));
  };
  Apply draco;
  draco.primitive()["extensions"]["KHR_draco_mesh_compression"] = {
      {"bufferView", 0}, {"attributes", {{"POSITION", 0}}}};
  noted(draco, "KHR_draco_mesh_compression");
  Apply meshopt; // a sparse accessor
  const std::size_t position = meshopt.primitive()["attributes"]["POSITION"];
  const std::size_t values = meshopt.scene.addView(std::as_bytes(std::span<const float>()));
  meshopt.scene.json["bufferViews"][values]["extensions"]["EXT_meshopt_compression"] = {
      {"buffer", 0}};
  meshopt.scene.json["accessors"][position]["sparse"]["values"]["bufferView"] = values;
  meshopt.scene.json["extensionsRequired"] = {"EXT_meshopt_compression"};
  noted(meshopt, "EXT_meshopt_compression");
}

TEST_CASE("the report lists frames, singularities and factors that multiply the noise") {
  const Apply apply;
  const json report = jsonOf(apply.arguments(wool(), "glass", kSurface));
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
  CHECK_THAT(apply.notes(wool(), "glass", kSurface),
             Catch::Contains("singular triangle") && Catch::Contains(place.str()));
  CHECK_THAT(apply.notes(moss(), "wood"), Catch::Contains("baseColorFactor [0.5,0.25,0.125,1]") &&
                                              Catch::Contains("material 'wood'"));
  CHECK(apply.notes(moss(), "wood", {"--quiet"}).empty());
}

TEST_CASE("factors are kept or set to 1, and one note lists many materials'") {
  Apply apply;
  apply.material()["pbrMetallicRoughness"]["baseColorFactor"] = {0.800000011920929, 0, 0, 0.51};
  apply.material(1)["pbrMetallicRoughness"]["baseColorFactor"] = {0.05, 0.09, 0, 1};
  for (int more = 0; more < 6; ++more)
    apply.scene.json["materials"].push_back(
        {{"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.5, 0.5, 1}}}}});
  const std::string kept = apply.notes(moss(), "all", kTriplanar);
  CHECK_THAT(kept,
             Catch::Contains("baseColorFactor [0.8,0,0,0.51] of material 'wood', baseColorFactor "
                             "[0.5,0.5,0.5,1] of material 2,") &&
                 Catch::Contains("and 3 others multiply the noise") &&
                 Catch::Contains("--factors one") &&
                 Catch::Contains("[0.05,0.09,0,1] of material 'glass' is below 0.1"));
  CHECK(std::count(kept.begin(), kept.end(), '\n') == 2);
  const json document = apply.document(moss(), "all", kTriplanar + Arguments{"--factors", "one"});
  const auto factorOf = [&](std::size_t material) {
    return document["materials"][material]["pbrMetallicRoughness"]["baseColorFactor"];
  };
  CHECK(factorOf(0) == json{1.0, 1.0, 1.0, 0.51});
  CHECK(factorOf(1) == json{1.0, 1.0, 1.0, 1.0});
  CHECK(factorOf(7) == json{1.0, 1.0, 1.0, 1.0});
}

TEST_CASE("setting an emissive factor to 1 without a texture gives a note") {
  Apply apply;
  std::filesystem::create_directory(apply.workplace.path("set"));
  for (const char* map : {"set/diff.png", "set/emissive.png"})
    apply.workplace.write(map, smooth(8));
  const std::string glow = bake(apply.workplace, apply.workplace.path("set"), "glow.glb");
  const auto note = Catch::Contains("emissiveFactor of material 'wood' is 1 without");
  CHECK_THAT(apply.notes(glow, "wood", {"--factors", "one"}), note);
  apply.material()["emissiveFactor"] = {1.0, 1.0, 1.0}; // it was emissive before
  CHECK_THAT(apply.notes(glow, "wood", {"--factors", "one"}), !note);
}

TEST_CASE("a note names the textures for which the noise has no map") {
  Apply apply;
  for (const char* slot : {"baseColorTexture", "metallicRoughnessTexture"})
    apply.material()["pbrMetallicRoughness"][slot] = {{"index", 0}};
  apply.material()["normalTexture"] = {{"index", 0}};
  CHECK_THAT(apply.notes(moss(), "wood"),
             Catch::Contains("normalTexture of material 'wood', metallicRoughnessTexture of "
                             "material 'wood' stay visible: the noise has no such map, or not all "
                             "its channels") &&
                 !Catch::Contains("baseColorTexture"));
}

TEST_CASE("quarter turns of tiles that are not square are an error, and half turns are not") {
  const Apply apply;
  const std::string plank =
      bake(apply.workplace, apply.workplace.write("plank.png", speckled(16, 8, 3)), "plank.glb");
  apply.refuses(plank, "wood", {"--tile-rotation", "4"},
                {"--tile-rotation 4", "'plank'", "not square", "none or 2"});
  checkRefusal({"synth", plank, "-o", apply.workplace.path("new.png"), "--tile-rotation", "4"},
               kUsage, {"tile rotation 4", "'plank'", "0, 1, 2, or 4 if tiles are square"});
  CHECK(apply.run(plank, "wood", {"--tile-rotation", "2"}).code == 0);
}

TEST_CASE("the options set every parameter that needs no new bake") {
  const Apply apply;
  CHECK(apply
            .run(moss(), "0",
                 {"--scale", "2", "--rotation", "90", "--seed", "7", "--contrast", "0.5",
                  "--sharpness", "4", "--tile-rotation", "4"})
            .code == 0);
  const MaterialNoise use = firstUse(apply);
  CHECK(use.scale == 2.0);
  CHECK(use.rotation == Approx(1.5707963267948966).epsilon(1e-12)); // 90 degrees, in radians
  CHECK(use.seed == 7);
  CHECK(use.contrast == 0.5);
  CHECK(use.blendSharpness == 4.0);
  CHECK(use.tileRotation == 4);
  const Arguments wooly{"--plane-sharpness", "4", "--impacts", "12.5", "--points", "poisson"};
  CHECK(apply.run(wool(), "0", kTriplanar + wooly).code == 0);
  const MaterialNoise texton = firstUse(apply);
  CHECK(texton.planeSharpness == 4.0);
  CHECK(texton.impacts == 12.5);
  CHECK(texton.pointProcess == PointProcess::poisson);
}

TEST_CASE("the space comes from the option, else from the bundle, and inspect shows it") {
  const Apply apply;
  const auto spaceIn = [](const json& document) {
    return document["materials"][0]["extensions"][kExtension].value("space", "none");
  };
  CHECK(spaceIn(apply.document(wool(), "0", kTriplanar + Arguments{"--space", "object"})) ==
        "object");
  const std::string made = apply.workplace.path("object.glb");
  std::filesystem::rename(apply.workplace.path("out.glb"), made);
  CHECK(jsonOf({"inspect", made}).at(json::json_pointer("/noises/0/materials/0/space")) ==
        "object");
  CHECK(spaceIn(apply.document(made, "0", kTriplanar)) == "object");
  CHECK(spaceIn(apply.document(made, "0", kTriplanar + Arguments{"--space", "world"})) == "none");
  CHECK(spaceIn(apply.document(made, "0")) == "none"); // with the mapping uv
}

TEST_CASE("the same call writes the same bytes on any number of threads") {
  const Apply apply;
  std::string first;
  for (const char* threads : {"1", "4"}) {
    succeed(apply.arguments(wool(), "all", kSurface + Arguments{"--threads", threads}));
    const std::string bytes = apply.workplace.read("out.glb");
    CHECK((first.empty() || bytes == first));
    first = bytes;
  }
}

TEST_CASE("options that are out of range, or that the noise or the mapping does not have, are "
          "errors") {
  const Apply apply;
  const Refused rows[] = {
      {{"--sharpness", "2"}, {"--sharpness", "'wool'", "texton", "tiling"}},
      {{"--tile-rotation", "4"}, {"--tile-rotation", "'wool'", "texton", "tiling"}},
      {{"--plane-sharpness", "2"}, {"--plane-sharpness", "uv", "--mapping triplanar"}},
      {{"--plane-sharpness", "65"}, {"--plane-sharpness 65", "1", "64"}},
      {{"--space", "object"}, {"--space object", "uv", "--mapping triplanar, surface or solid"}},
      {{"--scale", "0"}, {"--scale 0"}},
      {{"--impacts", "0.5"}, {"--impacts 0.5", "1 to 1000"}},
      {{"--factors", "2"}, {"--factors 2", "keep or one"}}};
  for (const Refused& row : rows)
    apply.refuses(wool(), "0", row.arguments, row.words);
}

TEST_CASE("unusable scenes, noises and outputs are errors and leave no file") {
  const Apply apply;
  const Workplace& workplace = apply.workplace;
  const std::string scene = apply.written(), output = workplace.path("x.glb");
  const std::string image = workplace.write("image.png", smooth(8));
  const std::string empty = workplace.write("empty.gltf", R"({"asset":{"version":"2.0"}})");
  const std::string twice = workplace.write(
      "twice.gltf", R"({"asset":{"version":"2.0"},"materials":[{}],"materials":[{}]})");
  const std::tuple<std::string, std::string, std::string, int, Arguments> rows[] = {
      {image, wool(), output, kBadInput, {"image.png"}},
      {workplace.path("none.glb"), wool(), output, kBadInput, {"none.glb"}},
      {scene, image, output, kBadInput, {"image.png"}},
      {scene, scene, output, kBadInput, {"scene.glb", "no noise"}},
      {empty, wool(), output, kBadInput, {"empty.gltf", "no materials"}},
      {twice, wool(), output, kBadInput, {"twice.gltf", "two members \"materials\""}},
      {scene, wool(), workplace.path("x.png"), kUsage, {".glb", ".gltf"}},
      {scene, wool(), workplace.path("none/x.glb"), kEnvironment, {"none"}}};
  for (const auto& [from, noise, to, code, words] : rows)
    checkRefusal(
        {"apply", from, "--noise", noise, "--material", "0", "--mapping", "triplanar", "-o", to},
        code, words);
  checkRefusal({"apply", scene, "--noise", wool(), "-o", output}, kUsage,
               {"--material is required"});
  CHECK(!std::filesystem::exists(output));
}
