// SPDX-License-Identifier: MIT
// The tangent frames that `lichen apply` adds to meshes for noise on surfaces.
#include "apply_run.h"

#include <lichen/files.h>
#include <lichen/gltf_scene.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstring>

using namespace lichen;
using namespace lichen::cli_test;
using nlohmann::json;

namespace {

/// Returns the first three components of a float attribute in the binary chunk of a .glb.
std::vector<std::array<float, 3>> vectorsOf(const std::string& file, PrimitivePlace place,
                                            const std::string& name) {
  const GltfScene scene = GltfScene::open(file).value();
  const json& document = scene.document();
  const std::size_t accessor = *scene.attribute(place, name);
  const json& view =
      document["bufferViews"][document["accessors"][accessor]["bufferView"].get<std::size_t>()];
  const Result<std::vector<std::byte>> bytes = readFile(file);
  const std::size_t text = 20 + std::to_integer<std::size_t>(bytes.value()[12]) +
                           256 * std::to_integer<std::size_t>(bytes.value()[13]);
  const std::size_t components = document["accessors"][accessor]["type"] == "VEC4" ? 4 : 3;
  std::vector<std::array<float, 3>> values;
  for (std::size_t i = 0; i < document["accessors"][accessor]["count"]; ++i) {
    std::array<float, 4> value{0, 0, 0, 1};
    std::memcpy(value.data(),
                bytes.value().data() + text + 8 + view["byteOffset"].get<std::size_t>() +
                    4 * components * i,
                4 * components);
    CHECK(value[3] == 1.0f);
    values.push_back({value[0], value[1], value[2]});
  }
  return values;
}

float dot(const std::array<float, 3>& a, const std::array<float, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

} // namespace

TEST_CASE("surface noise gets a computed frame on a mesh without tangents") {
  const Workplace workplace;
  const std::string wool = writeTexton(workplace);
  const std::string scene = writeScene(workplace, example::tableScene());
  const json document = applied(workplace, scene, wool, "all", {"--mapping", "surface"});
  CHECK(document["materials"][1]["extensions"][kExtension]["mapping"] == "surface");
  const json before = example::tableScene().json["meshes"][0]["primitives"];
  const json& after = document["meshes"][0]["primitives"];
  CHECK(after[0]["attributes"]["NORMAL"] == before[0]["attributes"]["NORMAL"]);
  for (const std::size_t p : {0u, 1u}) {
    const auto normals = vectorsOf(workplace.path("out.glb"), {0, p}, "NORMAL");
    const auto tangents = vectorsOf(workplace.path("out.glb"), {0, p}, "TANGENT");
    REQUIRE(normals.size() == 4);
    REQUIRE(tangents.size() == 4);
    for (std::size_t v = 0; v < 4; ++v) {
      CHECK(dot(tangents[v], tangents[v]) == Approx(1.0).margin(1e-6));
      CHECK(dot(normals[v], normals[v]) == Approx(1.0).margin(1e-6));
      CHECK(std::abs(dot(normals[v], tangents[v])) < 1e-6);
    }
  }
  // Smooth normals of a tetrahedron point from its centre to its corners.
  const auto normals = vectorsOf(workplace.path("out.glb"), {0, 1}, "NORMAL");
  CHECK(normals[0][0] == Approx(1.0 / std::sqrt(3.0)));
  CHECK(normals[1][1] == Approx(-1.0 / std::sqrt(3.0)));
  // The square is flat, so all tangents are equal.
  const auto tangents = vectorsOf(workplace.path("out.glb"), {0, 0}, "TANGENT");
  for (const auto& tangent : tangents)
    CHECK(dot(tangent, tangents[0]) == Approx(1.0));
}

TEST_CASE("a mesh with tangents keeps them as its frame") {
  const Workplace workplace;
  const std::string wool = writeTexton(workplace);
  example::TinyScene scene = example::tableScene();
  auto& attributes = scene.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["TANGENT"] =
      scene.addFloats({0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1}, "VEC4", 4);
  scene.json["materials"][0]["normalTexture"] = {{"index", 0}}; // which uses the tangents
  const json document =
      applied(workplace, writeScene(workplace, scene), wool, "wood", {"--mapping", "surface"});
  CHECK(document["meshes"] == json(scene.json["meshes"]));
}

TEST_CASE("--material all skips materials that need their own tangents, with a note") {
  const Workplace workplace;
  const std::string wool = writeTexton(workplace);
  example::TinyScene scene = example::tableScene();
  scene.json["materials"][0]["normalTexture"] = {{"index", 0}};
  const Arguments surface{"--mapping", "surface"};
  const Ended ended = apply(workplace, writeScene(workplace, scene), wool, "all", surface);
  REQUIRE(ended.code == 0);
  CHECK_THAT(ended.errors, Catch::Contains("primitive 0 of mesh 'table': has no TANGENT") &&
                               Catch::Contains("; skipped material 'wood'\n"));
  const json document = GltfScene::open(workplace.path("out.glb")).value().document();
  CHECK(!document["materials"][0].contains("extensions"));
  CHECK(document["materials"][1].contains("extensions"));
  scene.json["materials"][1]["normalTexture"] = {{"index", 0}};
  checkRefusal({"apply", writeScene(workplace, scene), "--noise", wool, "--material", "all",
                "--mapping", "surface", "-o", workplace.path("x.glb")},
               int(ErrorKind::badInput), {"material 'wood'", "TANGENT"});
}

TEST_CASE("one note reports the singular triangles of many meshes, with an index for equal names") {
  const Workplace workplace;
  const std::string wool = writeTexton(workplace);
  example::TinyScene scene = example::tableScene();
  scene.json["meshes"].push_back(scene.json["meshes"][0]);
  const std::string path = writeScene(workplace, scene);
  const Ended ended = apply(workplace, path, wool, "glass", {"--mapping", "surface"});
  REQUIRE(ended.code == 0);
  CHECK_THAT(ended.errors, Catch::Contains(path + ": mesh 0 'table': the noise rotates around") &&
                               Catch::Contains("; 1 more mesh has such triangles"));
}

TEST_CASE("noise with its own normals does not need the tangents of a normal texture") {
  const Workplace workplace;
  std::filesystem::create_directory(workplace.path("bumps"));
  workplace.write("bumps/base_color.png", smooth(16));
  workplace.write("bumps/normal.png", smooth(16));
  const std::string bumps =
      bake(workplace, workplace.path("bumps"), "bumps.glb", {"--method", "texton"});
  const std::string wool = writeTexton(workplace); // a height map, no normal map
  example::TinyScene scene = example::tableScene();
  scene.json["materials"][0]["normalTexture"] = {{"index", 0}};
  const std::string path = writeScene(workplace, scene);
  const Ended ended = apply(workplace, path, bumps, "wood", {"--mapping", "surface"});
  INFO(ended.errors);
  REQUIRE(ended.code == 0);
  CHECK_THAT(ended.errors, Catch::Contains("material 'wood'") &&
                               Catch::Contains("normalTexture by the noise's tangents"));
  CHECK(vectorsOf(workplace.path("out.glb"), {0, 0}, "TANGENT").size() == 4);
  const Arguments surface{"--mapping", "surface"};
  CHECK(apply(workplace, path, wool, "wood", surface).code == int(ErrorKind::badInput));
  scene.json["materials"][0]["extensions"]["KHR_materials_anisotropy"] = json::object();
  CHECK(apply(workplace, writeScene(workplace, scene), bumps, "wood", surface).code ==
        int(ErrorKind::badInput));
}

TEST_CASE("the noise follows the axis of --grain on meshes without tangents") {
  const Workplace workplace;
  const std::string wool = writeTexton(workplace);
  example::TinyScene scene = example::tableScene();
  const std::string path = writeScene(workplace, scene);
  (void)applied(workplace, path, wool, "wood", {"--mapping", "surface", "--grain", "3,-4,5"});
  // The square is flat with normal z: the axis projects to (0.6, -0.8, 0).
  for (const auto& tangent : vectorsOf(workplace.path("out.glb"), {0, 0}, "TANGENT"))
    CHECK(dot(tangent, {0.6f, -0.8f, 0.0f}) == Approx(1.0));
  const auto refused = [&](const Arguments& more, const std::vector<std::string>& words) {
    Arguments arguments{"apply",      path, "--noise", wool,
                        "--material", "0",  "-o",      workplace.path("x.glb")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    checkRefusal(arguments, int(ErrorKind::usage), words);
  };
  refused({"--mapping", "triplanar", "--grain", "0,1,0"}, {"--grain", "triplanar", "surface"});
  refused({"--mapping", "surface", "--grain", "0,0,0"}, {"--grain 0,0,0", "X,Y,Z", "not all 0"});
  refused({"--mapping", "surface", "--grain", "0,1"}, {"--grain 0,1", "X,Y,Z"});
  auto& attributes = scene.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["TANGENT"] =
      scene.addFloats({0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1}, "VEC4", 4);
  const Ended noted = apply(workplace, writeScene(workplace, scene), wool, "wood",
                            {"--mapping", "surface", "--grain", "0,1,0"});
  CHECK(noted.code == 0);
  CHECK_THAT(noted.errors, Catch::Contains("primitive 0 of mesh 'table'") &&
                               Catch::Contains("instead of --grain"));
}
