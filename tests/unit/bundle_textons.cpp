// SPDX-License-Identifier: MIT
// Texton noises in a file: the size of their frames, messages, mixes, and what is read beside them.
// Faults are rows of bundle_faults.json.
#include "bundle_example.h"
#include "bundle_surgery.h"

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

TEST_CASE("the exemplar's size is the Gaussian image's, or the one that textons state") {
  const Bundle bundle = example::textonMix().bundle;
  const auto sizeOf = [&](std::size_t noise) {
    return exemplarSize(bundle, bundle.noises[noise], bundle.noises[noise].maps[0]);
  };
  CHECK(sizeOf(0) == std::array<std::uint32_t, 2>{4, 2});
  CHECK(sizeOf(1) == std::array<std::uint32_t, 2>{100, 50});
}
