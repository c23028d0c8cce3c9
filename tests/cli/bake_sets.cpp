// SPDX-License-Identifier: MIT
// `lichen bake` of material sets: which file is which map, what each map stores, and which sets are
// refused. Uniform maps survive a bake exactly, so most sets here use them.
#include "set_run.h"

#include <lichen/image_io.h>

#include <catch2/catch.hpp>

#include <map>

using namespace lichen;
using namespace lichen::cli_test;
using nlohmann::json;

namespace {

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

Catch::Matchers::StdString::ContainsMatcher noting(const std::string& words) {
  return Catch::Contains(nlohmann::json(words).dump().substr(1, words.size()));
}

std::string notesOf(const json& report) { return report.at("notes").dump(); }

const std::map<std::string, std::vector<std::string>> kEveryMap{
    {"baseColor", {"red", "green", "blue"}},
    {"normal", {"slopeX", "slopeY"}},
    {"occlusionRoughnessMetallic", {"occlusion", "roughness", "metallic"}},
    {"emissive", {"red", "green", "blue"}},
    {"height", {"height"}},
    {"opacity", {"opacity"}}};

} // namespace

// The names of each library have a table in exemplar_pixels.cpp.
TEST_CASE("the maps of a folder are recognised and keep their values") {
  const Workplace workplace;
  const Pixel glow{code(40), code(80), code(10)};
  const std::string folder = writeSet(workplace, {{"Metal009_2K-PNG_Color.png", kColor},
                                                  {"Metal009_2K-PNG_NormalGL.png", kNormal},
                                                  {"Metal009_ao_2k.png", {code(51)}},
                                                  {"roughness.PNG", {code(102)}},
                                                  {"metal.png", {code(153)}},
                                                  {"Metal009_2K-PNG_Emission.png", glow},
                                                  {"Metal009_2K-PNG_Displacement.png", {code(204)}},
                                                  {"opacity.png", {code(140)}}});
  workplace.write(std::filesystem::path(folder).filename().string() + "/readme_rough.txt",
                  std::string("not an image"));
  const json report = baked(workplace, {folder});
  CHECK(report.at("name") == std::filesystem::path(folder).filename().string());
  CHECK(mapsOf(report) == kEveryMap);
  checkValue(workplace, "baseColor", kColor);
  checkValue(workplace, "normal", kNormal);
  checkValue(workplace, "occlusionRoughnessMetallic", {code(51), code(102), code(153)});
  checkValue(workplace, "emissive", glow);
  checkValue(workplace, "height", {code(204)});
  checkValue(workplace, "opacity", {code(140)});
}

TEST_CASE("synth writes heights in 16 bits, and other maps in 8") {
  const Workplace workplace;
  const std::string color = workplace.write("stone_diff.png", smooth(16));
  const std::string height = workplace.write("stone_height.png", smoothGrey(16));
  const std::string bundle = workplace.path("stone.glb");
  succeed({"bake", color, height, "-o", bundle});
  constexpr std::size_t kBitDepth = 24; // offset in a PNG file: the byte after width and height
  for (const auto& [map, bits] : {std::pair{"baseColor", 8}, {"height", 16}}) {
    synth(workplace, bundle, {"--map", map, "--size", "16"});
    CHECK(int(workplace.read("synth.png")[kBitDepth]) == bits);
  }
}

TEST_CASE(
    "an EXR of a map stores normals as a normal map does, which bakes to the same normals, and "
    "data unchanged") {
  const Workplace workplace;
  const Arguments files{workplace.write("normal.png", flat(kNormal)),
                        workplace.write("rough.png", flat({code(102)}))};
  baked(workplace, files);
  const auto valueOf = [&](const std::string& map, const std::string& file) {
    succeed({"synth", workplace.path("set.glb"), "-o", workplace.path(file), "--map", map, "--size",
             "4"});
    return std::get<LinearImage>(readImage(workplace.path(file)).value().pixels).values;
  };
  const std::vector<float> normals = valueOf("normal", "normal.exr");
  for (std::size_t c = 0; c < 3; ++c) // kNormal has unit length, up to rounding
    CHECK(normals[c] == Approx(kNormal[c]).margin(0.5 / 255.0));
  const std::vector<float> orm = valueOf("occlusionRoughnessMetallic", "orm.exr");
  CHECK(orm[0] == 1.0f); // no occlusion map
  CHECK(orm[1] == Approx(code(102)).margin(0.5 / 255.0));
  CHECK(orm[2] == 1.0f);
  const json report = baked(workplace, {workplace.path("normal.exr"), files[1]});
  CHECK_THAT(notesOf(report), !noting("point into the surface"));
  checkValue(workplace, "normal", kNormal);
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
  const auto meanWith = [&](const std::string& name, const Pixel& value,
                            const Arguments& more = {}) {
    baked(workplace, {writeSet(workplace, {{name, value}})}, more);
    return meanOfMap(workplace, "normal");
  };
  const std::vector<double> up = meanWith("nor_gl.png", kNormal);
  CHECK(meanWith("RockNormalDX.png", kNormalDown, {"--normal", "gl"}) == up);
  CHECK(meanWith("nor_gl.png", kNormal, {"--normal", "dx"}) == up);
  CHECK(meanWith("normal.png", kNormal) == up);
  CHECK(meanWith("normal.png", kNormalDown, {"--normal", "dx"}) == up);
  CHECK(meanWith("normal.png", kNormalDown) != up);
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
  CHECK_THAT(notesOf(baked(workplace, {input, rough})),
             noting("8 of 16 normals point into the surface"));
}

TEST_CASE("a separate file is preferred to a channel of a packed map, with a note") {
  const Pixel packed{code(51), code(102), code(153)};
  const FlatFile rough{"rough.png", {code(30)}}, ao{"ao.png", {code(40)}},
      metal{"metal.png", {code(60)}};
  const std::tuple<std::vector<FlatFile>, Arguments, Pixel> rows[] = {
      {{{"rock_arm_2k.png", packed}, {"rock_rough_2k.png", {code(30)}}},
       {"the roughness of rock_arm_2k.png is not used: rock_rough_2k.png has it"},
       {code(51), code(30), code(153)}},
      {{{"orm.png", packed}, rough, ao, metal},
       {"the roughness of orm.png", "the occlusion of orm.png",
        "the metallic of orm.png is not used: metal.png has it"},
       {code(40), code(30), code(60)}},
      {{{"metallicRoughness.png", packed}, rough},
       {"the roughness of metallicRoughness.png"},
       {1.0f, code(30), code(153)}}};
  for (const auto& [files, notes, wanted] : rows) {
    const Workplace workplace;
    const json report = baked(workplace, {writeSet(workplace, files)});
    for (const std::string& note : notes)
      CHECK_THAT(notesOf(report), noting(note));
    CHECK_THAT(notesOf(report), !noting("has colours"));
    checkValue(workplace, "occlusionRoughnessMetallic", wanted);
  }
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
  CHECK_THAT(notesOf(report), noting("the maps are read from the folder textures"));
  CHECK(report.at("name") == "wall");
  checkValue(workplace, "baseColor", kColor);
  makeFolder(workplace, "wall/more");
  workplace.write("wall/more/rough.png", flat({0.5f}));
  checkRefusal({"bake", workplace.path("wall"), "-o", workplace.path("new.glb")}, kBadInput,
               {"wall: a folder without a map", "inside that have maps: more, textures"});
}

TEST_CASE("notes name maps that are not used, and images that match no map") {
  const Pixel any{0.5f, 0.5f, 0.9f};
  const Workplace workplace;
  CHECK_THAT(
      notesOf(baked(workplace,
                    {writeSet(workplace, {{"Rock_NormalDX.png", {code(128), code(128), code(255)}},
                                          {"Rock_NormalGL.png", kNormal}})})),
      noting("Rock_NormalDX.png is not used: Rock_NormalGL.png"));
  checkValue(workplace, "normal", kNormal); // OpenGL's
  for (const auto& [name, target] : {std::pair{"height.png", "height"},
                                     {"opacity.png", "opacity"},
                                     {"emissive.png", "emissive"},
                                     {"rough.png", "occlusionRoughnessMetallic"},
                                     {"nor_gl.png", "normal"}}) { // every map is optional
    const json report =
        baked(workplace, {writeSet(workplace, {{name, any}, {"sphere.png", {0.5f}}})});
    REQUIRE(report.at("maps").size() == 1);
    CHECK(report.at("maps")[0].at("target") == target);
    CHECK_THAT(notesOf(report),
               noting("sphere.png is not used: its name does not say which map it is"));
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
  const std::string color = "baseColor red", orm = "occlusionRoughnessMetallic ";
  const Pixel grey{code(102)};
  const std::tuple<std::string, Pixel, std::string, std::string> rows[] = {
      {"oak_diff_1k.png", kColor, color, ""},
      {"oak.png", grey, color, ""},
      {"oak_rough_1k.png", grey, orm + "roughness", "is baked as roughness, as its name says"},
      {"height.png", grey, "height height", "is baked as height"},
      {"oak_ao.png", {grey[0], grey[0], grey[0]}, orm + "occlusion", "is baked as occlusion"},
      {"oak_nor_dx.png", kNormalDown, "normal slopeX", "is baked as normals"},
      {"arm.png", kColor, orm + "occlusion", "is baked as occlusion, roughness, metallic"},
      {"glow_emissive.png", kColor, "emissive red", "is baked as emissive light"},
      {"rusty_metal.png", kColor, color, "has colours, so it is baked as the base colour"},
      {"quite_normal.png", grey, color, "has no colours, so it is baked as the base colour"}};
  for (const auto& [name, value, target, note] : rows) {
    INFO(name);
    const json report = baked(workplace, {workplace.write(name, flat(value))});
    CHECK(report.at("name") == name.substr(0, name.find('.')));
    CHECK_THAT(notesOf(report), noting(note));
    if (note.empty())
      CHECK_THAT(notesOf(report), !noting("the base colour"));
    const auto maps = mapsOf(report);
    REQUIRE(maps.size() == 1);
    CHECK(maps.begin()->first + " " + maps.begin()->second.front() == target);
    if (target == "normal slopeX")
      checkValue(workplace, "normal", kNormal);
  }
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
  const std::string notes = notesOf(report);
  CHECK(mapsOf(report) == kEveryMap);
  CHECK_THAT(notes, noting("color.png has an alpha channel that is not all opaque; it is ignored"));
  CHECK_THAT(notes, !noting("--alpha opacity")); // the set has an opacity map
  CHECK_THAT(notes, noting("emissive.exr has values above 1"));
  CHECK_THAT(notes, noting("ao.png, metal.png, rough.png differ in size"));
  for (const auto& [target, channels] : kEveryMap) {
    INFO(target);
    CHECK(meanOfMap(workplace, target).size() == (channels.size() == 1 ? 1 : 3));
  }
}

TEST_CASE("the errors for a folder without a map and for two files of one map name them") {
  const Workplace workplace;
  const std::string out = workplace.path("new.glb");
  const std::pair<Arguments, Arguments> rows[] = {
      {{}, {"a folder without PNG, JPEG or EXR images"}},
      {{"sphere.png"}, {"a folder without a map: sphere.png (no map);", "diff, nor_gl"}},
      {{"a.png", "b.png", "c.png", "d.png", "e.png", "f.png", "g.png", "h.png"},
       {"f.png (no map) and 2 others; bake one of its images"}},
      {{"a_diff.png", "a_albedo.jpg"},
       {"a_albedo.jpg", "a_diff.png", "base colour", "'lichen mix'"}},
      {{"rock_arm.png", "rock_orm.png"}, {"rock_orm.png", "rock_arm.png", "occlusion"}},
      {{"rock_arm.png", "rock_rough.png", "rock_roughness.png"},
       {"rock_roughness.png", "rock_rough.png", "roughness"}},
      {{"nor_gl.png", "normal.png"}, {"normal.png", "nor_gl.png", "normals"}}};
  for (const auto& [names, words] : rows) {
    std::vector<FlatFile> files;
    for (const std::string& name : names)
      files.push_back({name, {0.5f, 0.5f, 0.9f}});
    checkRefusal({"bake", writeSet(workplace, files), "-o", out}, kBadInput, words);
  }
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
