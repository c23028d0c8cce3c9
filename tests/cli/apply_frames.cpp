// SPDX-License-Identifier: MIT
// The tangent frames that `lichen apply` adds to meshes for noise on surfaces.
#include "apply_run.h"

#include <lichen/files.h>
#include <lichen/gltf_scene.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstring>

using namespace lichen;
using namespace lichen::cli_test;
using nlohmann::json;

namespace {

/// Returns the first three components of a float attribute in the binary chunk of out.glb.
std::vector<std::array<float, 3>> vectorsOf(const Apply& apply, PrimitivePlace place,
                                            const std::string& name) {
  const std::string file = apply.workplace.path("out.glb");
  const GltfScene scene = GltfScene::open(file).value();
  const json& document = scene.document();
  const json& accessor = document["accessors"][*scene.attribute(place, name)];
  const json& view = document["bufferViews"][accessor["bufferView"].get<std::size_t>()];
  const Result<std::vector<std::byte>> bytes = readFile(file);
  const std::size_t text = 20 + std::to_integer<std::size_t>(bytes.value()[12]) +
                           256 * std::to_integer<std::size_t>(bytes.value()[13]);
  const std::size_t components = accessor["type"] == "VEC4" ? 4 : 3;
  std::vector<std::array<float, 3>> values;
  for (std::size_t i = 0; i < accessor["count"]; ++i) {
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

void addTangents(Apply& apply) {
  apply.primitive()["attributes"]["TANGENT"] =
      apply.scene.addFloats({0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1}, "VEC4", 4);
}

const Arguments kOnSurface{"--mapping", "surface"};

} // namespace

TEST_CASE("surface noise gets a computed frame on a mesh without tangents") {
  const Apply apply;
  const json document = apply.document(wool(), "all", kOnSurface);
  CHECK(document["materials"][1]["extensions"][kExtension]["mapping"] == "surface");
  const json before = apply.scene.json["meshes"][0]["primitives"];
  const json& after = document["meshes"][0]["primitives"];
  CHECK(after[0]["attributes"]["NORMAL"] == before[0]["attributes"]["NORMAL"]);
  for (const std::size_t p : {0u, 1u}) {
    const auto normals = vectorsOf(apply, {0, p}, "NORMAL");
    const auto tangents = vectorsOf(apply, {0, p}, "TANGENT");
    REQUIRE(normals.size() == 4);
    REQUIRE(tangents.size() == 4);
    for (std::size_t v = 0; v < 4; ++v) {
      CHECK(dot(tangents[v], tangents[v]) == Approx(1.0).margin(1e-6));
      CHECK(dot(normals[v], normals[v]) == Approx(1.0).margin(1e-6));
      CHECK(std::abs(dot(normals[v], tangents[v])) < 1e-6);
    }
  }
  // Smooth normals of a tetrahedron point from its centre to its corners.
  const auto normals = vectorsOf(apply, {0, 1}, "NORMAL");
  CHECK(normals[0][0] == Approx(1.0 / std::sqrt(3.0)));
  CHECK(normals[1][1] == Approx(-1.0 / std::sqrt(3.0)));
  // The square is flat, so all tangents are equal.
  const auto tangents = vectorsOf(apply, {0, 0}, "TANGENT");
  for (const auto& tangent : tangents)
    CHECK(dot(tangent, tangents[0]) == Approx(1.0));
}

TEST_CASE("a mesh with tangents keeps them as its frame") {
  Apply apply;
  addTangents(apply);
  apply.material()["normalTexture"] = {{"index", 0}}; // which uses the tangents
  CHECK(apply.document(wool(), "wood", kOnSurface)["meshes"] == json(apply.scene.json["meshes"]));
}

TEST_CASE("--material all skips materials that need their own tangents, with a note") {
  Apply apply;
  apply.material()["normalTexture"] = {{"index", 0}};
  CHECK_THAT(apply.notes(wool(), "all", kOnSurface),
             Catch::Contains("primitive 0 of mesh 'table': has no TANGENT") &&
                 Catch::Contains("; skipped material 'wood'\n"));
  const json document = apply.output();
  CHECK(!document["materials"][0].contains("extensions"));
  CHECK(document["materials"][1].contains("extensions"));
  apply.material(1)["normalTexture"] = {{"index", 0}};
  apply.refuses(wool(), "all", kOnSurface, {"material 'wood'", "TANGENT"}, kBadInput);
}

TEST_CASE("one note reports the singular triangles of many meshes, with an index for equal names") {
  Apply apply;
  apply.scene.json["meshes"].push_back(apply.scene.json["meshes"][0]);
  CHECK_THAT(apply.notes(wool(), "glass", kOnSurface),
             Catch::Contains(apply.written() + ": mesh 0 'table': the noise rotates around") &&
                 Catch::Contains("; 1 more mesh has such triangles"));
}

TEST_CASE("noise with its own normals does not need the tangents of a normal texture") {
  Apply apply;
  std::filesystem::create_directory(apply.workplace.path("bumps"));
  for (const char* map : {"bumps/base_color.png", "bumps/normal.png"})
    apply.workplace.write(map, smooth(16));
  const std::string bumps =
      bake(apply.workplace, apply.workplace.path("bumps"), "bumps.glb", {"--method", "texton"});
  apply.material()["normalTexture"] = {{"index", 0}};
  CHECK_THAT(apply.notes(bumps, "wood", kOnSurface),
             Catch::Contains("material 'wood'") &&
                 Catch::Contains("normalTexture by the noise's tangents"));
  CHECK(vectorsOf(apply, {0, 0}, "TANGENT").size() == 4);
  apply.refuses(wool(), "wood", kOnSurface, {"TANGENT"}, kBadInput); // no normal map
  apply.material()["extensions"]["KHR_materials_anisotropy"] = json::object();
  apply.refuses(bumps, "wood", kOnSurface, {"TANGENT"}, kBadInput);
}

TEST_CASE("the noise follows the axis of --grain on meshes without tangents") {
  Apply apply;
  (void)apply.document(wool(), "wood", kOnSurface + Arguments{"--grain", "3,-4,5"});
  // The square is flat with normal z: the axis projects to (0.6, -0.8, 0).
  for (const auto& tangent : vectorsOf(apply, {0, 0}, "TANGENT"))
    CHECK(dot(tangent, {0.6f, -0.8f, 0.0f}) == Approx(1.0));
  apply.refuses(wool(), "0", {"--mapping", "triplanar", "--grain", "0,1,0"},
                {"--grain", "triplanar", "surface"});
  apply.refuses(wool(), "0", kOnSurface + Arguments{"--grain", "0,0,0"},
                {"--grain 0,0,0", "X,Y,Z", "not all 0"});
  apply.refuses(wool(), "0", kOnSurface + Arguments{"--grain", "0,1"}, {"--grain 0,1", "X,Y,Z"});
  addTangents(apply);
  CHECK_THAT(apply.notes(wool(), "wood", kOnSurface + Arguments{"--grain", "0,1,0"}),
             Catch::Contains("primitive 0 of mesh 'table'") &&
                 Catch::Contains("instead of --grain"));
}
