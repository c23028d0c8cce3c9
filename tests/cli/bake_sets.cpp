// SPDX-License-Identifier: MIT
// `lichen bake` of material sets: which file is which map, what each map stores, and which sets are
// refused. Uniform maps survive a bake exactly, so most sets here use them.
#include "set_run.h"

#include <lichen/image_io.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <map>

using namespace lichen;
using namespace lichen::cli_test;
using nlohmann::json;

namespace {

constexpr int kBadInput = int(ErrorKind::badInput);

/// Returns target -> channels from a report.
std::map<std::string, std::vector<std::string>> mapsOf(const json& report) {
  std::map<std::string, std::vector<std::string>> maps;
  for (const json& map : report.at("maps"))
    maps[map.at("target")] = map.at("channels").get<std::vector<std::string>>();
  return maps;
}

/// Returns the mean of a map of set.glb, from the PNG that `lichen synth` writes.
std::vector<double> meanOfMap(const Workplace& workplace, const std::string& map) {
  return meanOf(synth(workplace, workplace.path("set.glb"), {"--map", map, "--size", "64"}));
}

void checkValue(const Workplace& workplace, const std::string& map, const Pixel& wanted) {
  INFO(map);
  const std::vector<double> found = meanOfMap(workplace, map);
  REQUIRE(found.size() == wanted.size());
  for (std::size_t c = 0; c < wanted.size(); ++c)
    CHECK(found[c] ==
          Approx(double(wanted[c])).margin(1.5 / 255.0)); // rounding by the table and by PNG
}

bool hasNote(const json& report, const std::string& words) {
  for (const json& note : report.at("notes"))
    if (note.get<std::string>().find(words) != std::string::npos)
      return true;
  return false;
}

const std::map<std::string, std::vector<std::string>> kEveryMap{
    {"baseColor", {"red", "green", "blue"}},
    {"normal", {"slopeX", "slopeY"}},
    {"occlusionRoughnessMetallic", {"occlusion", "roughness", "metallic"}},
    {"emissive", {"red", "green", "blue"}},
    {"height", {"height"}},
    {"opacity", {"opacity"}}};

} // namespace

TEST_CASE("the maps of a folder are recognised in every naming scheme and keep their values") {
  const Workplace workplace;
  const std::map<std::string, std::vector<std::string>> schemes{
      {"poly_haven",
       {"old_wall_02_diff_2k.png", "old_wall_02_nor_gl_2k.png", "old_wall_02_ao_2k.png",
        "old_wall_02_rough_2k.png", "old_wall_02_metal_2k.png", "old_wall_02_emissive_2k.png",
        "old_wall_02_disp_2k.png", "old_wall_02_opacity_2k.png"}},
      {"ambientCG",
       {"Metal009_2K-PNG_Color.png", "Metal009_2K-PNG_NormalGL.png",
        "Metal009_2K-PNG_AmbientOcclusion.png", "Metal009_2K-PNG_Roughness.png",
        "Metal009_2K-PNG_Metalness.png", "Metal009_2K-PNG_Emission.png",
        "Metal009_2K-PNG_Displacement.png", "Metal009_2K-PNG_Opacity.png"}},
      {"plain",
       {"base_color.png", "normal.png", "occlusion.png", "roughness.png", "METALLIC.PNG",
        "emissive.png", "height.png", "opacity.png"}}};
  const std::vector<Pixel> values{kColor,      kNormal,     {code(51)},
                                  {code(102)}, {code(153)}, {code(40), code(80), code(10)},
                                  {code(204)}, {code(140)}};
  for (const auto& [scheme, names] : schemes) {
    INFO(scheme);
    makeFolder(workplace, scheme);
    for (std::size_t f = 0; f < names.size(); ++f)
      workplace.write(scheme + "/" + names[f], encodePng(flat(values[f]), 8).value());
    workplace.write(scheme + "/readme_rough.txt", "not an image");
    const json report = baked(workplace, {workplace.path(scheme)});
    CHECK(report.at("name") == scheme);
    CHECK(mapsOf(report) == kEveryMap);
    checkValue(workplace, "baseColor", kColor);
    checkValue(workplace, "normal", kNormal);
    checkValue(workplace, "occlusionRoughnessMetallic", {code(51), code(102), code(153)});
    checkValue(workplace, "emissive", values[5]);
    checkValue(workplace, "height", values[6]);
    checkValue(workplace, "opacity", values[7]);
  }
}

TEST_CASE("synth writes heights in 16 bits, and other maps in 8") {
  const Workplace workplace;
  const std::string color = workplace.write("stone_diff.png", smooth(16));
  const std::string height = workplace.write("stone_height.png", smoothGrey(16));
  const std::string bundle = workplace.path("stone.glb");
  REQUIRE(runLichen({"bake", color, height, "-o", bundle, "--transport", "fast"}).code == 0);
  constexpr std::size_t kBitDepth = 24; // offset in a PNG file: the byte after width and height
  for (const auto& [map, bits] : {std::pair{"baseColor", 8}, {"height", 16}}) {
    synth(workplace, bundle, {"--map", map, "--size", "16"});
    CHECK(int(workplace.read("synth.png")[kBitDepth]) == bits);
  }
}

TEST_CASE("an EXR of a map stores normals as a normal map does, and data unchanged") {
  const Workplace workplace;
  makeFolder(workplace, "set");
  workplace.write("set/normal.png", flat(kNormal));
  workplace.write("set/rough.png", flat({code(102)}));
  baked(workplace, {workplace.path("set")});
  const auto valueOf = [&](const std::string& map) {
    REQUIRE(runLichen({"synth", workplace.path("set.glb"), "-o", workplace.path("v.exr"), "--map",
                       map, "--size", "4"})
                .code == 0);
    return std::get<LinearImage>(readImage(workplace.path("v.exr")).value().pixels).values;
  };
  const std::vector<float> normals = valueOf("normal");
  for (std::size_t c = 0; c < 3; ++c) // kNormal has unit length, up to rounding
    CHECK(normals[c] == Approx(kNormal[c]).margin(0.5 / 255.0));
  const std::vector<float> orm = valueOf("occlusionRoughnessMetallic");
  CHECK(orm[0] == 1.0f); // no occlusion map
  CHECK(orm[1] == Approx(code(102)).margin(0.5 / 255.0));
  CHECK(orm[2] == 1.0f);
}

TEST_CASE("separate and packed occlusion, roughness and metallic become one map") {
  const Workplace workplace;
  const SrgbImage packed = speckled(24, 16, 3);
  const std::vector<std::string> names{"ao", "rough", "metal"};
  for (const char* folder : {"apart", "packed", "two", "gltf"})
    makeFolder(workplace, folder);
  for (int c = 0; c < 3; ++c) {
    SrgbImage one(24, 16, 1);
    for (std::size_t i = 0; i < one.values.size(); ++i)
      one.values[i] = packed.values[3 * i + std::size_t(c)];
    workplace.write("apart/" + names[std::size_t(c)] + ".png", one);
    if (c > 0)
      workplace.write("two/" + names[std::size_t(c)] + ".png", one);
  }
  workplace.write("packed/stone_arm_1k.png", packed);
  workplace.write("gltf/stone_metallicRoughness.png", packed);
  const auto bundle = [&](const std::string& folder) {
    baked(workplace, {workplace.path(folder)}, {"--name", "x"});
    return workplace.read("set.glb");
  };
  CHECK((bundle("apart") == bundle("packed")));
  CHECK((bundle("two") == bundle("gltf")));
  CHECK((bundle("two") != bundle("packed")));
}

TEST_CASE("the name of a normal map, else --normal, decides whether green is up") {
  const Workplace workplace;
  const auto bundle = [&](const std::string& name, const Pixel& value, const Arguments& more) {
    const std::string folder = "f" + std::to_string(workplace.names().size());
    makeFolder(workplace, folder);
    workplace.write(folder + "/" + name, flat(value));
    baked(workplace, {workplace.path(folder)}, more);
    return meanOfMap(workplace, "normal");
  };
  const std::vector<double> up = bundle("nor_gl.png", kNormal, {});
  CHECK(bundle("nor_dx.png", kNormalDown, {}) == up);
  CHECK(bundle("RockNormalDX.png", kNormalDown, {"--normal", "gl"}) == up);
  CHECK(bundle("nor_gl.png", kNormal, {"--normal", "dx"}) == up);
  CHECK(bundle("normal.png", kNormal, {}) == up);
  CHECK(bundle("normal.png", kNormalDown, {"--normal", "dx"}) == up);
  CHECK(bundle("normal.png", kNormalDown, {}) != up);
}

TEST_CASE("the EXR of a noise's normals bakes to the same normals") {
  const Workplace workplace;
  const std::string png = workplace.write("normal.png", flat(kNormal));
  const std::string rough = workplace.write("rough.png", flat({code(102)}));
  baked(workplace, {png, rough});
  REQUIRE(runLichen({"synth", workplace.path("set.glb"), "-o", workplace.path("normal.exr"),
                     "--map", "normal", "--size", "8"})
              .code == 0);
  const json report = baked(workplace, {workplace.path("normal.exr"), rough});
  CHECK_FALSE(hasNote(report, "point into the surface"));
  checkValue(workplace, "normal", kNormal);
}

TEST_CASE("a normal map with most normals inward is an error, with a few a note") {
  const Workplace workplace;
  const std::string rough = workplace.write("rough.png", flat({code(102)}));
  SrgbImage normals = flat(kNormal); // 16 pixels
  for (int i = 0; i < 9; ++i)
    normals.values[std::size_t(3 * i + 2)] = code(20);
  const std::string input = workplace.write("normal.png", normals);
  checkRefusal({"bake", input, rough, "-o", workplace.path("new.glb")}, kBadInput,
               {"normal.png: 9 of 16 normals point into the surface", "blue above one half"});
  normals.values[2] = kNormal[2];
  workplace.write("normal.png", normals);
  CHECK(hasNote(baked(workplace, {input, rough}), "8 of 16 normals point into the surface"));
}

TEST_CASE("a separate file is preferred to a channel of a packed map, with a note") {
  const Workplace workplace;
  const Pixel packed{code(51), code(102), code(153)};
  const auto check = [&](const std::vector<std::pair<std::string, Pixel>>& files,
                         const std::vector<std::string>& notes, const Pixel& wanted) {
    const std::string folder = "f" + std::to_string(workplace.names().size());
    makeFolder(workplace, folder);
    for (const auto& [name, value] : files)
      workplace.write(folder + "/" + name, flat(value));
    const json report = baked(workplace, {workplace.path(folder)});
    for (const std::string& note : notes)
      CHECK(hasNote(report, note));
    CHECK_FALSE(hasNote(report, "has colours"));
    checkValue(workplace, "occlusionRoughnessMetallic", wanted);
  };
  check({{"rock_arm_2k.png", packed}, {"rock_rough_2k.png", {code(30)}}},
        {"the roughness of rock_arm_2k.png is not used: rock_rough_2k.png has it"},
        {code(51), code(30), code(153)});
  check({{"orm.png", packed}, {"roughness.png", {code(30)}}, {"ao.png", {code(40)}}},
        {"the roughness of orm.png", "the occlusion of orm.png"}, {code(40), code(30), code(153)});
  check({{"orm.png", packed},
         {"roughness.png", {code(30)}},
         {"ao.png", {code(40)}},
         {"metal.png", {code(60)}}},
        {"the metallic of orm.png is not used: metal.png has it"}, {code(40), code(30), code(60)});
  check({{"rock_arm.png", packed}, {"rock_rough.png", {code(30)}}, {"rock_metal.png", {code(60)}}},
        {"the roughness of rock_arm.png", "the metallic of rock_arm.png"},
        {code(51), code(30), code(60)});
  check({{"metallicRoughness.png", packed}, {"roughness.png", {code(30)}}},
        {"the roughness of metallicRoughness.png"}, {1.0f, code(30), code(153)});
}

TEST_CASE("a folder without maps stands for its only subfolder with maps") {
  const Workplace workplace;
  makeFolder(workplace, "wall");
  makeFolder(workplace, "wall/textures");
  makeFolder(workplace, "wall/source");
  workplace.write("wall/wall.blend", "not an image");
  workplace.write("wall/textures/diff.png", flat(kColor));
  workplace.write("wall/source/sphere.png", flat({0.5f}));
  const json report = baked(workplace, {workplace.path("wall")});
  CHECK(hasNote(report, "the maps are read from the folder textures"));
  CHECK(report.at("name") == "wall");
  checkValue(workplace, "baseColor", kColor);
  makeFolder(workplace, "wall/more");
  workplace.write("wall/more/rough.png", flat({0.5f}));
  checkRefusal({"bake", workplace.path("wall"), "-o", workplace.path("new.glb")}, kBadInput,
               {"wall: a folder without a map", "inside that have maps: more, textures"});
}

TEST_CASE("a note names maps that seem to be of two materials") {
  const Workplace workplace;
  const auto isNoted = [&](const std::vector<std::string>& names) {
    const std::string folder = "f" + std::to_string(workplace.names().size());
    makeFolder(workplace, folder);
    for (const std::string& name : names)
      workplace.write(folder + "/" + name, flat({0.5f, 0.5f, 0.9f}));
    return hasNote(baked(workplace, {workplace.path(folder)}), "suggest two materials");
  };
  CHECK(isNoted({"a_diff.png", "b_nor_gl.png"}));
  CHECK(isNoted({"rock_01_diff.png", "rock_02_rough.png"}));
  CHECK_FALSE(isNoted({"rock_01_diff_2k.png", "Rock01_4K-PNG_NormalGL.png", "rough.png"}));
}

TEST_CASE("OpenGL normals are preferred to DirectX normals, with a note") {
  const Workplace workplace;
  makeFolder(workplace, "set");
  workplace.write("set/Rock_NormalDX.png", flat({code(128), code(128), code(255)}));
  workplace.write("set/Rock_NormalGL.png", flat(kNormal));
  const json report = baked(workplace, {workplace.path("set")});
  CHECK(hasNote(report, "Rock_NormalDX.png is not used: Rock_NormalGL.png"));
  checkValue(workplace, "normal", kNormal);
}

TEST_CASE("every map of a set is optional, and a note lists images that match no map") {
  const Workplace workplace;
  for (const auto& [name, target] : {std::pair{"height.png", "height"},
                                     {"opacity.png", "opacity"},
                                     {"emissive.png", "emissive"},
                                     {"rough.png", "occlusionRoughnessMetallic"},
                                     {"nor_gl.png", "normal"}}) {
    const std::string folder = std::string("only_") + target;
    makeFolder(workplace, folder);
    workplace.write(folder + "/" + name, speckled(12, 12, 3));
    workplace.write(folder + "/sphere.png", flat({0.5f}));
    const json report = baked(workplace, {workplace.path(folder)});
    REQUIRE(report.at("maps").size() == 1);
    CHECK(report.at("maps")[0].at("target") == target);
    CHECK(hasNote(report, "sphere.png is not used: its name does not say which map it is"));
    const SrgbImage image =
        synth(workplace, workplace.path("set.glb"), {"--map", target, "--size", "8"});
    CHECK(image.width == 8);
  }
}

TEST_CASE("several files form a set") {
  const Workplace workplace;
  const std::string color = workplace.write("oak_bark_diff_1k.png", flat(kColor));
  const std::string rough = workplace.write("oak_bark_rough_1k.png", flat({code(102)}));
  const json both = baked(workplace, {color, rough});
  CHECK(both.at("name") == "oak_bark");
  CHECK(mapsOf(both).count("baseColor") == 1);
  CHECK(mapsOf(both).at("occlusionRoughnessMetallic") == std::vector<std::string>{"roughness"});
  // Only whole words count as a map name: not stone_di.
  const json stone = baked(workplace, {workplace.write("stone_diff.png", flat(kColor)),
                                       workplace.write("stone_disp.png", flat({code(102)}))});
  CHECK(stone.at("name") == "stone");
}

TEST_CASE(
    "a single image is baked as the map that its name says, unless its colours contradict it") {
  const Workplace workplace;
  const auto targetOf = [&](const std::string& name, const Pixel& value, const std::string& note) {
    INFO(name);
    const json report = baked(workplace, {workplace.write(name, flat(value))});
    CHECK(report.at("name") == name.substr(0, name.find('.')));
    CHECK(hasNote(report, note.empty() ? "the base colour" : note) == !note.empty());
    const auto maps = mapsOf(report);
    REQUIRE(maps.size() == 1);
    return maps.begin()->first + " " + maps.begin()->second.front();
  };
  const std::string color = "baseColor red", orm = "occlusionRoughnessMetallic ";
  const Pixel grey{code(102)};
  CHECK(targetOf("oak_diff_1k.png", kColor, "") == color);
  CHECK(targetOf("oak.png", grey, "") == color);
  CHECK(targetOf("oak_rough_1k.png", grey, "is baked as roughness, as its name says") ==
        orm + "roughness");
  CHECK(targetOf("height.png", grey, "is baked as height") == "height height");
  CHECK(targetOf("oak_ao.png", {grey[0], grey[0], grey[0]}, "is baked as occlusion") ==
        orm + "occlusion");
  CHECK(targetOf("oak_nor_dx.png", kNormalDown, "is baked as normals") == "normal slopeX");
  checkValue(workplace, "normal", kNormal);
  CHECK(targetOf("arm.png", kColor, "is baked as occlusion, roughness, metallic") ==
        orm + "occlusion");
  CHECK(targetOf("glow_emissive.png", kColor, "is baked as emissive light") == "emissive red");
  CHECK(targetOf("rusty_metal.png", kColor, "has colours, so it is baked as the base colour") ==
        color);
  CHECK(targetOf("quite_normal.png", grey, "has no colours, so it is baked as the base colour") ==
        color);
}

TEST_CASE("images of every kind and size work inside a set") {
  const Workplace workplace;
  makeFolder(workplace, "set");
  LinearImage bright = toLinear(speckled(13, 7, 3));
  for (float& value : bright.values)
    value *= 8.0f;
  workplace.write("set/color.png", encodePng(speckled(17, 11, 2), 16).value()); // grey and alpha
  workplace.write("set/emissive.exr", bright);
  workplace.write("set/normal.png", encodePng(speckled(16, 16, 4), 8).value());
  workplace.write("set/ao.png", flat({code(51)}, 1, 1));
  workplace.write("set/rough.png", speckled(1, 23, 1));
  workplace.write("set/metal.png", speckled(23, 1, 3));
  workplace.write("set/height.png", encodePng(speckled(5, 31, 1), 16).value());
  workplace.write("set/opacity.png", speckled(32, 8, 4));
  const json report = baked(workplace, {workplace.path("set")});
  CHECK(mapsOf(report) == kEveryMap);
  CHECK(hasNote(report, "color.png has an alpha channel that is not all opaque; it is ignored"));
  CHECK_FALSE(hasNote(report, "--alpha opacity")); // the set has an opacity map
  CHECK(hasNote(report, "emissive.exr has values above 1"));
  CHECK(hasNote(report, "ao.png, metal.png, rough.png differ in size"));
  for (const auto& [target, channels] : kEveryMap) {
    INFO(target);
    CHECK(meanOfMap(workplace, target).size() == (channels.size() == 1 ? 1 : 3));
  }
}

TEST_CASE("the errors for a folder without a map and for two files of one map name them") {
  const Workplace workplace;
  const std::string out = workplace.path("new.glb");
  const auto refuses = [&](const std::vector<std::string>& files,
                           const std::vector<std::string>& words) {
    const std::string folder = "f" + std::to_string(workplace.names().size());
    makeFolder(workplace, folder);
    for (const std::string& file : files)
      workplace.write(folder + "/" + file, encodePng(flat({0.5f, 0.5f, 0.9f}), 8).value());
    checkRefusal({"bake", workplace.path(folder), "-o", out}, kBadInput, words);
  };
  refuses({}, {"a folder without PNG, JPEG or EXR images"});
  refuses({"sphere.png"}, {"a folder without a map: sphere.png (no map);", "diff, nor_gl"});
  refuses({"a.png", "b.png", "c.png", "d.png", "e.png", "f.png", "g.png", "h.png"},
          {"f.png (no map) and 2 others; bake one of its images"});
  refuses({"a_diff.png", "a_albedo.jpg"},
          {"a_albedo.jpg", "a_diff.png", "base colour", "'lichen mix'"});
  refuses({"rock_arm.png", "rock_orm.png"}, {"rock_orm.png", "rock_arm.png", "occlusion"});
  refuses({"rock_arm.png", "rock_rough.png", "rock_roughness.png"},
          {"rock_roughness.png", "rock_rough.png", "roughness"});
  refuses({"nor_gl.png", "normal.png"}, {"normal.png", "nor_gl.png", "normals"});
  const std::string nameless = workplace.write("sphere.png", flat(kColor));
  const std::string color = workplace.write("diff.png", flat(kColor));
  checkRefusal({"bake", color, nameless, "-o", out}, kBadInput,
               {"sphere.png: its name does not say which map it is", "rough",
                "diff.png (base colour), sphere.png (no map); bake one photograph at a time, blend "
                "photographs with 'lichen mix'"});
  const std::string grey = workplace.write("orm.png", flat({0.5f}));
  checkRefusal({"bake", color, grey, "-o", out}, kBadInput, {"orm.png: a grey image"});
  CHECK(!std::filesystem::exists(out));
}
