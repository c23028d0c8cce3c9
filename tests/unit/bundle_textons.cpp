// SPDX-License-Identifier: MIT
// Texton noises in a file: the size of their frames, and every fault that the checker must report
// by its code and the reader must reject.
#include "bundle_example.h"
#include "bundle_faults.h"

#include <catch2/catch.hpp>

#include <cstring>

using namespace lichen;
using example::GlbParts;
using nlohmann::json;

namespace {

// In example::textonMix(), noise 0 is a tiling noise, "felt", with tables 0 and 1. Noise 1 has the
// textons of base colour (table 2, RGBA16F), normal (3, RGBA32F) and height (4, R32F) in three
// steps.
const std::vector<std::byte>& soundFile() {
  static const std::vector<std::byte> file = encodeGlb(example::textonMix()).value();
  return file;
}

json& shapeOf(GlbParts& parts) { return parts.extension()["noises"][1]["texton"]; }

} // namespace

TEST_CASE("the example file of textons has no faults before they are inserted") {
  CHECK(checkBundle(GlbParts(soundFile()).join()).empty());
}

TEST_CASE("a frame has whole texels of the last mip level, plus one of zeros on each axis") {
  for (const int coefficients : {1, 2, 3, 4, 7, 8, 15, 16, 17, 63, 64, 1023, 1024}) {
    TextonShape shape;
    shape.coefficientsX = shape.coefficientsY = coefficients;
    const int most = shape.mostMipLevels();
    CHECK(most <= kMaxTextonMips);
    CHECK((most == 1 || 4 << (most - 1) <= coefficients)); // four texels of the last mip
    CHECK(4 << most > coefficients);                       // and one more would not fit
    for (shape.mipLevels = 1; shape.mipLevels <= most; ++shape.mipLevels) {
      const int coarse = 1 << (shape.mipLevels - 1);
      const int frame = int(shape.frameWidth());
      CHECK(frame % coarse == 0);
      CHECK(frame - coefficients >= coarse);
      CHECK(frame - coefficients < 2 * coarse);
      CHECK(shape.frameHeight() == shape.frameWidth());
    }
  }
  TextonShape flat;
  flat.coefficientsX = 1024;
  flat.coefficientsY = 5;
  CHECK(flat.mostMipLevels() == 1);
}

TEST_CASE("every fault of the shape of textons is found") {
  example::checkFaults(
      soundFile(),
      {
          {"no shape", "required", [](GlbParts& p) { p.extension()["noises"][1].erase("texton"); }},
          {"the shape is a number", "type", [](GlbParts& p) { shapeOf(p) = 7; }},
          {"no coefficients", "required", [](GlbParts& p) { shapeOf(p).erase("coefficients"); }},
          {"one side", "count", [](GlbParts& p) { shapeOf(p)["coefficients"] = {9}; }},
          {"three sides", "count",
           [](GlbParts& p) {
             shapeOf(p)["coefficients"] = {9, 17, 1};
           }},
          {"half a coefficient", "type", [](GlbParts& p) { shapeOf(p)["coefficients"][0] = 9.5; }},
          {"no side", "range", [](GlbParts& p) { shapeOf(p)["coefficients"][1] = 0; }},
          {"a huge side", "range", [](GlbParts& p) { shapeOf(p)["coefficients"][1] = 1025; }},
          {"a side that no integer holds", "range",
           [](GlbParts& p) { shapeOf(p)["coefficients"][1] = 1e300; }},
          {"a side in text", "type", [](GlbParts& p) { shapeOf(p)["coefficients"][1] = "17"; }},
          {"no order", "required", [](GlbParts& p) { shapeOf(p).erase("order"); }},
          {"order 2", "range", [](GlbParts& p) { shapeOf(p)["order"] = 2; }},
          {"order 4", "range", [](GlbParts& p) { shapeOf(p)["order"] = 4; }},
          {"order 1.5", "type", [](GlbParts& p) { shapeOf(p)["order"] = 1.5; }},
          {"no mips", "range", [](GlbParts& p) { shapeOf(p)["mipLevels"] = 0; }},
          {"ten mips", "range", [](GlbParts& p) { shapeOf(p)["mipLevels"] = 10; }},
          {"mips coarser than the texton", "texton-mip-levels",
           [](GlbParts& p) { shapeOf(p)["mipLevels"] = 3; }},
          {"no size of the exemplar", "required",
           [](GlbParts& p) { shapeOf(p).erase("texelsPerTile"); }},
          {"an empty exemplar", "range", [](GlbParts& p) { shapeOf(p)["texelsPerTile"][0] = 0; }},
          {"a huge exemplar", "range", [](GlbParts& p) { shapeOf(p)["texelsPerTile"][0] = 16385; }},
          {"more coefficients than texels", "texton-coefficients",
           [](GlbParts& p) { shapeOf(p)["texelsPerTile"][1] = 16; }},
          {"no steps", "range", [](GlbParts& p) { shapeOf(p)["steps"] = 0; }},
          {"too many steps", "range", [](GlbParts& p) { shapeOf(p)["steps"] = 65; }},
          {"steps in text", "type", [](GlbParts& p) { shapeOf(p)["steps"] = "3"; }},
          {"frames higher than an image", "texton-steps",
           [](GlbParts& p) {
             shapeOf(p)["coefficients"] = {9, 1024};
             shapeOf(p)["texelsPerTile"] = {9, 1024};
             shapeOf(p)["steps"] = 64;
           }},
      });
}

TEST_CASE("every contradiction between a map and its texton is found") {
  example::checkFaults(
      soundFile(),
      {
          {"texton out of range", "map-texton-index",
           [](GlbParts& p) { p.map(1, 0)["texton"] = 99; }},
          {"negative texton", "map-texton-index", [](GlbParts& p) { p.map(1, 0)["texton"] = -1; }},
          {"no texton", "required", [](GlbParts& p) { p.map(1, 0).erase("texton"); }},
          {"a texton of one channel", "map-texton", [](GlbParts& p) { p.map(1, 0)["texton"] = 4; }},
          {"an image of another size", "map-texton",
           [](GlbParts& p) { p.map(1, 2)["texton"] = 0; }},
          {"more coefficients than the frame holds", "map-texton",
           [](GlbParts& p) { shapeOf(p)["coefficients"][0] = 11; }},
          {"fewer steps than frames", "map-texton", [](GlbParts& p) { shapeOf(p)["steps"] = 2; }},
          {"fewer mips than the image has", "map-texton",
           [](GlbParts& p) {
             shapeOf(p)["coefficients"] = {11, 19}; // their frames with one mip have the same size
             shapeOf(p)["mipLevels"] = 1;
           }},
          {"no scale", "required", [](GlbParts& p) { p.map(1, 0).erase("scale"); }},
          {"a short scale", "map-scale", [](GlbParts& p) { p.map(1, 0)["scale"].erase(2); }},
          {"a negative scale", "range", [](GlbParts& p) { p.map(1, 0)["scale"][0] = -0.5; }},
          {"a huge scale", "range", [](GlbParts& p) { p.map(1, 0)["scale"][0] = 1e7; }},
          {"a scale in text", "type", [](GlbParts& p) { p.map(1, 0)["scale"] = "0.6"; }},
          {"a scale that is not six deviations", "texton-scale",
           [](GlbParts& p) {
             json& scale = p.map(1, 0)["scale"];
             scale[0] = 1.001 * scale[0].get<double>();
           }},
          {"a texel whose sum could be infinite", "texton-texels",
           [](GlbParts& p) {
             constexpr std::size_t kLevelIndex = 80; // of a KTX2 file
             const std::size_t file = p.tableOffset(3);
             const float texel = -4.5f;
             std::memcpy(&p.binary[file + GlbParts::word(p.binary, file + kLevelIndex)], &texel,
                         sizeof texel);
           }},
          {"no losses", "required", [](GlbParts& p) { p.map(1, 0).erase("mipLoss"); }},
          {"fewer losses than mips", "map-mip-loss",
           [](GlbParts& p) { p.map(1, 0)["mipLoss"] = {0.0}; }},
          {"losses of all channels together", "map-mip-loss",
           [](GlbParts& p) { p.map(1, 0)["mipLoss"] = std::vector<double>(16, 0.0); }},
          {"fewer losses than mips a channel", "map-mip-loss",
           [](GlbParts& p) { p.map(1, 0)["mipLoss"] = std::vector<double>(3, 0.0); }},
          {"more losses than are known", "map-mip-loss",
           [](GlbParts& p) { p.map(1, 0)["mipLoss"] = std::vector<double>(3 * 17, 0.0); }},
          {"a loss of the first channel at level 0", "map-mip-loss",
           [](GlbParts& p) { p.map(1, 0)["mipLoss"][0] = 0.1; }},
          {"a loss of the third channel at level 0", "map-mip-loss",
           [](GlbParts& p) { p.map(1, 0)["mipLoss"][6] = 0.1; }},
          {"losses of the third channel that decrease", "map-mip-loss",
           [](GlbParts& p) { p.map(1, 0)["mipLoss"][8] = 0.0; }},
          {"a texton where tiling has a Gaussian image", "required",
           [](GlbParts& p) { p.extension()["noises"][1]["method"] = "tiling"; }},
      });
}

TEST_CASE("losses of a texton are refused if their count does not fit the channels or if they "
          "fall") {
  const auto messageOf = [](const std::vector<double>& losses) {
    GlbParts parts(soundFile());
    parts.map(1, 0)["mipLoss"] = losses;
    const std::vector<Finding> findings = checkBundle(parts.join());
    const auto found = std::find_if(findings.begin(), findings.end(), [](const Finding& finding) {
      return finding.code == "map-mip-loss" &&
             finding.pointer.find("laterSteps") == std::string::npos;
    });
    return found == findings.end() ? std::string() : found->message;
  };
  CHECK(messageOf(std::vector<double>(16, 0.0)) ==
        "16 values; expected as many for each of 3 channels, 2 to 16 each");
  CHECK(messageOf({0.0}).starts_with("1 value; expected as many for each of 3 channels"));
  // These are the losses of channels that are constant except for the last.
  CHECK(messageOf({0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5, 0.6}) == "");
  CHECK(messageOf({0.0, 0.5, 0.6, 0.0, 0.5, 0.6, 0.0, 0.5, 0.4}) ==
        "0.4 at 8; expected no less than the mip level before, 0.5");
  CHECK(messageOf({0.0, 0.5, 0.6, 0.1, 0.5, 0.6, 0.0, 0.5, 0.6}) ==
        "0.1 at 3; expected 0: level 0 loses nothing");
}

TEST_CASE("every fault of a mix's later steps is found") {
  const auto steps = [](GlbParts& p) -> json& { return p.map(1, 0)["laterSteps"]; };
  example::checkFaults(
      soundFile(),
      {
          {"a mix without later steps", "map-later-steps",
           [](GlbParts& p) { p.map(1, 0).erase("laterSteps"); }},
          {"later steps without a mix", "map-later-steps",
           [](GlbParts& p) { shapeOf(p)["steps"] = 1; }},
          {"a step too few", "map-later-steps", [&](GlbParts& p) { steps(p).erase(1); }},
          {"a step too many", "map-later-steps",
           [&](GlbParts& p) { steps(p).push_back(steps(p)[0]); }},
          {"no steps", "count", [&](GlbParts& p) { steps(p) = json::array(); }},
          {"more steps than there can be", "count",
           [&](GlbParts& p) { steps(p) = json::array_t(65, steps(p)[0]); }},
          {"steps in text", "type", [&](GlbParts& p) { steps(p) = "fast"; }},
          {"a step that is a number", "type", [&](GlbParts& p) { steps(p)[1] = 7; }},
          {"a step without a mean", "required", [&](GlbParts& p) { steps(p)[1].erase("mean"); }},
          {"a short mean", "map-mean", [&](GlbParts& p) { steps(p)[1]["mean"].erase(2); }},
          {"a mean out of range", "range", [&](GlbParts& p) { steps(p)[0]["mean"][1] = 2.0; }},
          {"a step without a covariance", "required",
           [&](GlbParts& p) { steps(p)[0].erase("covariance"); }},
          {"a covariance of one channel", "map-covariance",
           [&](GlbParts& p) { steps(p)[0]["covariance"] = {0.01}; }},
          {"a covariance that is not symmetric", "map-covariance",
           [&](GlbParts& p) { steps(p)[0]["covariance"][1] = 0.004; }},
          {"a negative variance", "map-covariance",
           [&](GlbParts& p) { steps(p)[0]["covariance"][0] = -0.01; }},
          {"a step without losses", "required", [&](GlbParts& p) { steps(p)[1].erase("mipLoss"); }},
          {"other levels than the first step's", "map-mip-loss",
           [&](GlbParts& p) { steps(p)[1]["mipLoss"].erase(2); }},
          {"a loss at level 0", "map-mip-loss",
           [&](GlbParts& p) { steps(p)[1]["mipLoss"][0] = 0.1; }},
          {"losses of all channels together", "map-mip-loss",
           [&](GlbParts& p) {
             steps(p)[1]["mipLoss"] = {0.0, 0.5, 0.8};
           }},
          {"losses of the second channel that decrease", "map-mip-loss",
           [&](GlbParts& p) { steps(p)[1]["mipLoss"][5] = 0.0; }},
      });
}

TEST_CASE("every fault of a mix's weight is found") {
  const auto mix = [](GlbParts& p) -> json& { return p.use(1)["mix"]; };
  const auto withTexture = [&](GlbParts& p, const json& info) {
    p.json["textures"] = {json::object(), json::object()};
    mix(p) = {{"source", "texture"}, {"texture", info}};
  };
  example::checkFaults(
      soundFile(),
      {
          {"a mix in text", "type", [&](GlbParts& p) { mix(p) = "moss"; }},
          {"no source", "required", [&](GlbParts& p) { mix(p).erase("source"); }},
          {"an unknown source", "mix-source", [&](GlbParts& p) { mix(p)["source"] = "height"; }},
          {"a source that is a number", "type", [&](GlbParts& p) { mix(p)["source"] = 1; }},
          {"a weight above 1", "range",
           [&](GlbParts& p) {
             mix(p) = {{"source", "constant"}, {"weight", 1.5}};
           }},
          {"a weight below 0", "range",
           [&](GlbParts& p) {
             mix(p) = {{"source", "constant"}, {"weight", -0.5}};
           }},
          {"a direction without length", "mix-direction",
           [&](GlbParts& p) {
             mix(p) = {{"source", "direction"}, {"start", {0.0, 1.0}}};
           }},
          {"a direction whose squared length is 0", "mix-direction",
           [&](GlbParts& p) {
             mix(p) = {{"source", "direction"}, {"end", {0.0, 1e-200}}};
           }},
          {"a direction that is too short", "mix-direction",
           [&](GlbParts& p) {
             mix(p) = {{"source", "direction"}, {"end", {0.0, 0.9e-6}}};
           }},
          {"a start of one number", "count",
           [&](GlbParts& p) {
             mix(p) = {{"source", "direction"}, {"start", {0.5}}};
           }},
          {"an end far away", "range",
           [&](GlbParts& p) {
             mix(p) = {{"source", "direction"}, {"end", {0.0, 1e7}}};
           }},
          {"no texture", "required",
           [&](GlbParts& p) {
             mix(p) = {{"source", "texture"}};
           }},
          {"no textures", "mix-texture-index",
           [&](GlbParts& p) {
             mix(p) = {{"source", "texture"}, {"texture", {{"index", 0}}}};
           }},
          {"a texture out of range", "mix-texture-index",
           [&](GlbParts& p) {
             withTexture(p, {{"index", 2}});
           }},
          {"a texture without index", "required",
           [&](GlbParts& p) { withTexture(p, json::object()); }},
          {"a texture that is a number", "type", [&](GlbParts& p) { withTexture(p, 1); }},
          {"texture coordinates 16", "range",
           [&](GlbParts& p) {
             withTexture(p, {{"index", 1}, {"texCoord", 16}});
           }},
          {"a fifth channel", "range", [&](GlbParts& p) { mix(p)["channel"] = 4; }},
          {"a channel in text", "type", [&](GlbParts& p) { mix(p)["channel"] = "red"; }},
          {"vertex colours 16", "range", [&](GlbParts& p) { mix(p)["set"] = 16; }},
      });
}

TEST_CASE("the weight of a mix survives the round trip for every source") {
  for (MixWeight mix :
       {MixWeight{.weight = 0.25},
        MixWeight{.source = MixSource::direction, .start = {0.5, 2.0}, .end = {-1.0, 0.0}},
        MixWeight{.source = MixSource::direction, .end = {0.0, 1e-6}},
        MixWeight{.source = MixSource::texture, .texture = 1, .texCoord = 1, .channel = 3},
        MixWeight{.source = MixSource::vertexColor, .colorSet = 2, .channel = 1}}) {
    BundleFile file = example::textonMix();
    file.previews.front().baseColor = file.previews.front().normal = example::tinyPng();
    file.bundle.materials[1]->mix = mix;
    const auto parsed = parseBundle(encodeGlb(file).value(), "mix.glb");
    if (!parsed)
      FAIL(parsed.error().message);
    CHECK(parsed.value().materials[1]->mix == mix);
  }
}

TEST_CASE("every fault of a material's use of textons is found") {
  example::checkFaults(
      soundFile(),
      {
          {"too few impacts", "range", [](GlbParts& p) { p.use(1)["impacts"] = 0.5; }},
          {"too many impacts", "range", [](GlbParts& p) { p.use(1)["impacts"] = 1001; }},
          {"impacts in text", "type", [](GlbParts& p) { p.use(1)["impacts"] = "30"; }},
          {"an unknown process", "material-point-process",
           [](GlbParts& p) { p.use(1)["pointProcess"] = "blue"; }},
          {"a process that is a number", "type", [](GlbParts& p) { p.use(1)["pointProcess"] = 1; }},
          {"a solid of textons", "material-mapping",
           [](GlbParts& p) { p.use(1)["mapping"] = "solid"; }},
          {"a surface of tiling", "material-mapping",
           [](GlbParts& p) { p.use(0)["mapping"] = "surface"; }},
      });
}

TEST_CASE("a fault in a shape is reported once, and not for its maps") {
  GlbParts parts(soundFile());
  SECTION("absent") { parts.extension()["noises"][1].erase("texton"); }
  SECTION("not an object") { shapeOf(parts) = nullptr; }
  SECTION("of no size") { shapeOf(parts)["coefficients"][0] = 0; }
  SECTION("of too many mips") { shapeOf(parts)["mipLevels"] = 3; }
  const std::vector<Finding> findings = checkBundle(parts.join());
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].pointer.starts_with(
      "/extensions/LICHEN_materials_exemplar_noise/noises/1/texton"));
}

TEST_CASE("members of the other method are a warning, not an error") {
  GlbParts parts(soundFile());
  SECTION("a shape of tiling") { parts.extension()["noises"][0]["texton"] = shapeOf(parts); }
  SECTION("a scale of tiling") { parts.map(0, 0)["scale"] = {0.6}; }
  SECTION("an inverse table of textons") { parts.map(1, 2)["inverseTable"] = 1; }
  const std::vector<std::byte> file = parts.join();
  CHECK(parseBundle(file, "odd.glb").ok());
  const std::vector<Finding> findings = checkBundle(file);
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].code == "unknown-property");
}

TEST_CASE("textons are read beside an ignored noise, whose tables are skipped") {
  GlbParts parts(soundFile());
  parts.extension()["noises"][0] = {
      {"name", "felt"}, {"method", "magic"}, {"revision", 2}, {"spell", 7}};
  parts.setTableWord(0, 12, 131); // vkFormat: VK_FORMAT_BC1_RGB_UNORM_BLOCK
  const auto parsed = parseBundle(parts.join(), "later.glb");
  if (!parsed)
    FAIL(parsed.error().message);
  const Bundle& bundle = parsed.value();
  REQUIRE(bundle.noises.size() == 1);
  CHECK(bundle.noises[0].method() == Method::texton);
  const Bundle all = example::textonMix().bundle;
  REQUIRE(bundle.tables.size() == 3);
  for (std::size_t m = 0; m < 3; ++m)
    CHECK(bundle.tables[bundle.noises[0].maps[m].as<TextonMap>().image].texels ==
          all.tables[all.noises[1].maps[m].as<TextonMap>().image].texels);
}

TEST_CASE("the exemplar's size is that of the Gaussian image, or the one that textons state") {
  const Bundle bundle = example::textonMix().bundle;
  const auto sizeOf = [&](std::size_t noise) {
    return exemplarSize(bundle, bundle.noises[noise], bundle.noises[noise].maps[0]);
  };
  CHECK(sizeOf(0) == std::array<std::uint32_t, 2>{4, 2});
  CHECK(sizeOf(1) == std::array<std::uint32_t, 2>{100, 50});
}
