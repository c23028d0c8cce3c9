// SPDX-License-Identifier: MIT
// lichen synth --all-maps: which textures each program gets, and what their channels hold.
#include "set_run.h"

#include <lichen/image_io.h>

#include <catch2/catch.hpp>

#include <filesystem>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

using namespace lichen;
using namespace lichen::cli_test;

namespace {

constexpr int kSide = 64;

/// One bundle for all tests of this file, with colours, normals, roughness and metallic, a smaller
/// height, and opacity.
struct Made {
  Made() {
    const std::string folder = "set";
    makeFolder(workplace, folder);
    for (const auto& [name, channels, side] : {std::tuple{"base_color.png", 3, kSide},
                                               {"roughness.png", 1, kSide},
                                               {"metallic.png", 1, kSide},
                                               {"height.png", 1, kSide / 2},
                                               {"opacity.png", 1, kSide}})
      workplace.write(folder + "/" + name, speckled(side, side, channels));
    SrgbImage normal(kSide, kSide, 3);
    for (std::size_t i = 0; i < normal.pixelCount(); ++i)
      std::copy_n((i / 8 % 2 == 0 ? kNormal : kNormalDown).begin(), 3, &normal.values[3 * i]);
    workplace.write(folder + "/normal.png", normal);
    bundle = bake(workplace, workplace.path(folder), "noise.glb", {"--name", "old wall/1"});
  }
  Workplace workplace;
  std::string bundle;
};
const Made& made() {
  static const Made set;
  return set;
}

/// Writes the textures into a new folder of `workplace` and returns their names.
std::vector<std::string> writeTextures(const Workplace& workplace, const Arguments& more) {
  return jsonOf(Arguments{"synth", made().bundle, "--all-maps", "-o",
                          workplace.path("new/textures"), "--size", "64", "--tileable"} +
                more)
      .at("files");
}

SrgbImage pngOf(const Workplace& workplace, const std::string& name) {
  const Result<ImageFile> image = readImage(workplace.path("new/textures/" + name));
  REQUIRE(image);
  return std::get<SrgbImage>(image.value().pixels);
}

/// The map alone, as `synth` writes it, on tiles of the size of the largest map's.
SrgbImage alone(const std::string& map) {
  return synth(made().workplace, made().bundle,
               {"--map", map, "--size", "64", "--tileable", "--texels-per-tile", "64"});
}

} // namespace

TEST_CASE("each program gets the textures of all maps under the names that it knows") {
  const std::string stem = "old_wall_1_";
  const auto expected = [&](const std::string& program, const Arguments& suffixes) {
    const Workplace workplace;
    const std::vector<std::string> files = writeTextures(workplace, {"--for", program});
    std::vector<std::string> names;
    for (const std::string& suffix : suffixes)
      names.push_back((program == "unreal" ? "T_" : "") + stem + suffix + ".png");
    INFO(program);
    CHECK(files == names);
    for (const std::string& name : names)
      CHECK(pngOf(workplace, name).width == kSide);
  };
  expected("blender", {"BaseColor", "Normal", "Roughness", "Metallic", "Height", "Opacity"});
  const Arguments packed{"BaseColor", "Normal", "OcclusionRoughnessMetallic", "Height", "Opacity"};
  expected("unreal", packed);
  expected("godot", {"BaseColor", "Normal", "OcclusionRoughnessMetallic", "Height"});
  expected("unity", {"BaseColor", "Normal", "MaskMap", "Height"});
}

TEST_CASE("the textures have the maps' channels, packed as each program has them") {
  const SrgbImage orm = alone("occlusionRoughnessMetallic"), normal = alone("normal");
  const Workplace blender, unity, unreal, up;
  writeTextures(blender, {});
  writeTextures(unity, {"--for", "unity"});
  writeTextures(unreal, {"--for", "unreal"});
  writeTextures(up, {"--for", "unreal", "--green", "up"});
  CHECK(pngOf(blender, "old_wall_1_BaseColor.png").values == alone("baseColor").values);
  CHECK(pngOf(blender, "old_wall_1_Height.png").values == alone("height").values); // 16 bits
  CHECK(pngOf(blender, "old_wall_1_Normal.png").values == normal.values);
  CHECK(pngOf(unreal, "T_old_wall_1_OcclusionRoughnessMetallic.png").values == orm.values);
  const SrgbImage roughness = pngOf(blender, "old_wall_1_Roughness.png");
  const SrgbImage mask = pngOf(unity, "old_wall_1_MaskMap.png");
  const SrgbImage down = pngOf(unreal, "T_old_wall_1_Normal.png");
  REQUIRE(roughness.channels == 1);
  REQUIRE(mask.channels == 4);
  constexpr double kHalfCode = 0.51 / 255.0;
  for (std::size_t i = 0; i < orm.pixelCount(); ++i) {
    REQUIRE(roughness.values[i] == orm.values[3 * i + 1]);
    REQUIRE(mask.values[4 * i] == orm.values[3 * i + 2]);
    REQUIRE(mask.values[4 * i + 1] == 1.0f); // no occlusion
    REQUIRE(mask.values[4 * i + 2] == 0.0f);
    REQUIRE(double(mask.values[4 * i + 3]) ==
            Approx(1.0 - double(orm.values[3 * i + 1])).margin(kHalfCode));
    REQUIRE(down.values[3 * i] == normal.values[3 * i]);
    REQUIRE(double(down.values[3 * i + 1]) ==
            Approx(1.0 - double(normal.values[3 * i + 1])).margin(kHalfCode));
  }
  CHECK(pngOf(up, "T_old_wall_1_Normal.png").values == normal.values);
  // Colours with opacity, for programs that take it from there.
  const SrgbImage color = pngOf(unity, "old_wall_1_BaseColor.png");
  const SrgbImage plain = alone("baseColor"), opacity = alone("opacity");
  REQUIRE(color.channels == 4);
  for (std::size_t i = 0; i < plain.pixelCount(); ++i) {
    for (std::size_t c = 0; c < 3; ++c)
      REQUIRE(color.values[4 * i + c] == plain.values[3 * i + c]);
    REQUIRE(color.values[4 * i + 3] == opacity.values[i]);
  }
}

TEST_CASE("a material without metal is not metal in packed textures, and has its occlusion") {
  const Workplace workplace;
  makeFolder(workplace, "set");
  for (const char* name : {"base_color.png", "ao.png", "roughness.png"})
    workplace.write(std::string("set/") + name, speckled(kSide, kSide, name[0] == 'b' ? 3 : 1));
  const std::string bundle = bake(workplace, workplace.path("set"), "noise.glb", {"--name", "mud"});
  const auto texture = [&](const std::string& program, const std::string& name) {
    const std::string folder = workplace.path(program);
    succeed({"synth", bundle, "--all-maps", "-o", folder, "--size", "64", "--tileable", "--for",
             program});
    return std::get<SrgbImage>(readImage(folder + "/" + name).value().pixels);
  };
  const SrgbImage orm = texture("godot", "mud_OcclusionRoughnessMetallic.png"),
                  mask = texture("unity", "mud_MaskMap.png"),
                  occlusion = texture("blender", "mud_AmbientOcclusion.png");
  for (std::size_t i = 0; i < orm.pixelCount(); ++i) {
    REQUIRE(orm.values[3 * i + 2] == 0.0f);
    REQUIRE(mask.values[4 * i] == 0.0f);
    REQUIRE(mask.values[4 * i + 1] == orm.values[3 * i]);
    REQUIRE(occlusion.values[i] == orm.values[3 * i]);
  }
  CHECK(!std::filesystem::exists(workplace.path("blender") + "/mud_Metallic.png"));
}

TEST_CASE("textures as EXR hold linear light") {
  const Workplace workplace;
  const std::vector<std::string> files = writeTextures(workplace, {"--format", "exr"});
  REQUIRE(files.front() == "old_wall_1_BaseColor.exr");
  const Result<ImageFile> image = readImage(workplace.path("new/textures/" + files.front()));
  REQUIRE(image);
  const LinearImage light = std::get<LinearImage>(image.value().pixels);
  const LinearImage expected = toLinear(alone("baseColor"));
  REQUIRE(light.values.size() == expected.values.size());
  for (std::size_t i = 0; i < light.values.size(); ++i) // half a code of 8 bits of sRGB
    REQUIRE(double(light.values[i]) == Approx(double(expected.values[i])).margin(0.005));
}

TEST_CASE("options of all maps need --all-maps, and options of one map exclude it") {
  const std::string& bundle = made().bundle;
  const Workplace workplace;
  const std::string file = workplace.write("file", std::string("x"));
  checkRefusals(
      {"synth", bundle, "-o"},
      std::vector<Refused>{
          {{workplace.path("x.png"), "--for", "unity"}, {"--for", "--all-maps"}},
          {{workplace.path("x"), "--all-maps", "--map", "height"}, {"--map", "--all-maps"}},
          {{workplace.path("x"), "--all-maps", "--for", "maya"}, {"maya", "blender", "unreal"}},
          {{workplace.path("x.png"), "--all-maps"}, {"x.png", "folder"}},
          {{file + "/textures", "--all-maps"}, {file, "folder"}, kEnvironment}});
  CHECK_THAT(
      succeed({"synth", bundle, "-o", workplace.path("y"), "--all-maps", "--size", "16"}).errors,
      Catch::Contains("--tileable"));
}
