// SPDX-License-Identifier: MIT
// `lichen apply`: what it says about the size of a tile, against sizes worked out by hand.
#include "apply_run.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>

using namespace lichen;
using namespace lichen::cli_test;
using nlohmann::json;

namespace {

/// Pixels of a length at the centre of a sphere of this radius that touches the upper and lower
/// edge of a picture 1080 pixels high with a field of view of 45 degrees. The distance is radius /
/// sin 22.5, and the picture is 2 tan 22.5 times as high there.
double pixels(double length, double radius) {
  const double half = 22.5 * std::acos(-1.0) / 180.0;
  return 1080.0 * length / (2.0 * std::tan(half) * radius / std::sin(half));
}

/// The material 'wood' is on a square with a side of 1 m and texture coordinates from 0 to 1, so
/// its sphere has the radius sqrt(1/2). The noise's tile is 2 m.
struct Scene {
  Apply run;
  example::TinyScene& tiny = run.scene;
  std::string large =
      bake(run.workplace, run.workplace.write("moss.png", smooth(16)), "moss.glb", {"--tile", "2"});

  json report(const std::string& material, const Arguments& more = {}) {
    return jsonOf(run.arguments(large, material, more));
  }

  void checkTile(const std::string& material, const Arguments& more, const std::string& object,
                 double metres, double radius) {
    const json tiles = report(material, more).at("tiles");
    REQUIRE(tiles.size() == 1);
    CHECK(tiles[0].at("material") == "material '" + material + "'");
    CHECK(tiles[0].at("object") == object);
    CHECK(tiles[0].at("metres").get<double>() == Approx(metres).epsilon(1e-6));
    CHECK(tiles[0].at("pixels").get<double>() == Approx(pixels(metres, radius)).epsilon(1e-6));
  }
};

const double kSquareRadius = std::sqrt(0.5);

} // namespace

TEST_CASE("a tile on texture coordinates is measured with the scale of the node and its parents") {
  Scene scene;
  scene.checkTile("wood", {}, "node 0", 1.0, kSquareRadius);
  scene.checkTile("wood", {"--scale", "0.25"}, "node 0", 0.25, kSquareRadius);
  scene.tiny.json["nodes"] = {
      {{"children", {1}}, {"scale", {4, 4, 4}}, {"rotation", {0, 0.6, 0, 0.8}}},
      {{"name", "desk"}, {"mesh", 0}, {"scale", {0.5, 0.5, 0.5}}, {"translation", {9, 9, 9}}}};
  scene.checkTile("wood", {}, "node 'desk'", 2.0, 2 * kSquareRadius);
  scene.tiny.json["nodes"][1] = {{"mesh", 0},
                                 {"matrix", {0, 3, 0, 0, -3, 0, 0, 0, 0, 0, 3, 0, 5, 5, 5, 1}}};
  scene.checkTile("wood", {}, "node 1", 12.0, 12 * kSquareRadius);
}

TEST_CASE("a tile on texture coordinates is the median over the area of its object") {
  Scene scene;
  // The first triangle has half the square, and texture coordinates of 4 times the area; then the
  // third vertex moves, so that the second triangle has three times the area of the first.
  const auto square = [&](const std::vector<float>& positions) {
    scene.tiny.json["meshes"][0]["primitives"][0]["attributes"] = {
        {"POSITION", scene.tiny.addFloats(positions, "VEC3", 3)},
        {"TEXCOORD_0", scene.tiny.addFloats({0, 0, 2, 0, 0, 2, 0, 0, 0, 1, 1, 0}, "VEC2", 2)}};
    auto& primitive = scene.tiny.json["meshes"][0]["primitives"][0];
    primitive.erase("indices");
  };
  square({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 3, 0, 1, 0, 0}); // areas 1/2 and 3/2
  scene.checkTile("wood", {}, "node 0", std::sqrt(3.0), std::sqrt(0.25 + 2.25));
  square({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0.5F, 0, 1, 0, 0}); // areas 1/2 and 1/4
  scene.checkTile("wood", {}, "node 0", 0.5, kSquareRadius);
}

TEST_CASE("the object is the largest node with the material, in world space all of them") {
  Scene scene;
  scene.tiny.json["nodes"] = {{{"name", "stool"}, {"mesh", 0}},
                              {{"name", "desk"}, {"mesh", 0}, {"scale", {3, 3, 3}}},
                              {{"name", "elsewhere"}, {"mesh", 0}, {"scale", {9, 9, 9}}}};
  scene.tiny.json["scenes"] = {{{"nodes", {0, 1}}}};
  scene.checkTile("wood", {}, "node 'desk'", 3.0, 3 * kSquareRadius);
  scene.checkTile("wood", {"--mapping", "triplanar"}, "its 2 nodes", 2.0, 3 * kSquareRadius);
  scene.checkTile("wood", {"--mapping", "triplanar", "--space", "object"}, "node 'desk'", 6.0,
                  3 * kSquareRadius);
  // A pyramid with a corner at each second corner of a cube of 2 m.
  scene.tiny.json["scenes"] = {{{"nodes", {0}}}};
  scene.checkTile("glass", {"--mapping", "triplanar", "--scale", "0.5"}, "node 'stool'", 1.0,
                  std::sqrt(3.0));
}

TEST_CASE("a skinned mesh is measured as its joints transform it, not its node") {
  Scene scene;
  scene.tiny.json["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"scale", {50, 50, 50}}},
                              {{"name", "joint"}, {"scale", {0.01, 0.01, 0.01}}}};
  scene.tiny.json["scenes"] = {{{"nodes", {0, 1}}}};
  scene.tiny.json["skins"] = {{{"joints", {1}}}};
  scene.checkTile("wood", {}, "node 0", 0.01, 0.01 * kSquareRadius);
  const std::size_t bind =
      scene.tiny.addFloats({200, 0, 0, 0, 0, 200, 0, 0, 0, 0, 200, 0, 0, 0, 0, 1}, "MAT4", 16);
  scene.tiny.json["skins"][0]["inverseBindMatrices"] = bind;
  scene.checkTile("wood", {}, "node 0", 2.0, 2 * kSquareRadius);
}

TEST_CASE("apply says the size of a tile in words, for the first materials") {
  Scene scene;
  CHECK_THAT(
      succeed(scene.run.arguments(scene.large, "wood")).output,
      Catch::Contains("material 'wood': one tile is 1 m, 706 pixels when node 0 fills 1920 x "
                      "1080 pixels\n"));
  CHECK(succeed(scene.run.arguments(scene.large, "wood", {"--quiet"})).output.empty());
  for (int k = 0; k < 9; ++k) {
    scene.tiny.json["materials"].push_back(nlohmann::ordered_json::object());
    auto primitive = scene.tiny.json["meshes"][0]["primitives"][0];
    primitive["material"] = 2 + k;
    scene.tiny.json["meshes"][0]["primitives"].push_back(primitive);
  }
  const std::string many =
      succeed(scene.run.arguments(scene.large, "all")).output; // without 'glass'
  CHECK_THAT(many, Catch::Contains("material 8: one tile") && !Catch::Contains("material 9: ") &&
                       Catch::Contains("and 2 more; --json lists them\n"));
  CHECK(scene.report("all").at("tiles").size() == 10);
}

TEST_CASE("a note proposes a scale for tiles that are too small or too large") {
  Scene scene; // 706 pixels at scale 1
  const auto notesAt = [&](const char* scale) {
    return scene.run.notes(scene.large, "wood", {"--scale", scale, "--factors", "one"});
  };
  CHECK(notesAt("0.0228").empty());
  CHECK_THAT(notesAt("0.0225"),
             Catch::Contains("material 'wood': one tile is 16 pixels when node") &&
                 Catch::Contains("; --scale 0.091 makes it 64 pixels"));
  CHECK(notesAt("1.52").empty());
  CHECK_THAT(notesAt("1.54"), Catch::Contains("it is larger than the object") &&
                                  Catch::Contains("; --scale 0.36 makes it 256 pixels"));
  CHECK(notesAt("0.091").empty()); // the proposed values
  CHECK(notesAt("0.36").empty());
  CHECK_THAT(scene.run.notes(scene.large, "all", {"--mapping", "triplanar", "--scale", "90"}),
             Catch::Contains("material 'wood', material 'glass': one tile of the first is"));
}

TEST_CASE("a material that nothing shows, or whose tile has no size, gets a note") {
  const std::string unseen = "no node of the scene shows triangles with it";
  const std::string flat = "its texture coordinates have no area, so the noise does not vary";
  const std::pair<std::function<void(example::TinyScene&)>, std::string> faults[] = {
      {[](auto& tiny) { tiny.json["scenes"] = json::array({json::object()}); }, unseen},
      {[](auto& tiny) {
         tiny.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] =
             tiny.addFloats({0, 1, 0, 1, 0, 1, 0, 1}, "VEC2", 2);
       },
       flat},
      {[](auto& tiny) {
         tiny.json["nodes"][0]["scale"] = {0, 0, 0};
       },
       flat},
      {[](auto& tiny) { // nodes that violate glTF
         tiny.json["nodes"] = {{{"children", {1, 7, -1, "x"}}, {"scale", "large"}, {"mesh", 99}},
                               {{"children", {0, 1}}, {"mesh", "0"}, {"matrix", {1, 2}}},
                               3};
         tiny.json["scenes"] = {{{"nodes", {0, 2}}}};
       },
       unseen},
      {[](auto& tiny) {
         tiny.json["nodes"] = {{"mesh", 0}};
       },
       unseen},
      {[](auto& tiny) { tiny.json["scene"] = 5; }, unseen}};
  for (const auto& [breakIt, reason] : faults) {
    Scene scene;
    breakIt(scene.tiny);
    const json report = scene.report("wood");
    CHECK(report.at("tiles").empty());
    CHECK_THAT(report.at("notes").dump(),
               Catch::Contains("scene.glb: material 'wood': " + reason) &&
                   Catch::Contains("; the size of a tile is unknown on material 'wood'"));
  }
}
