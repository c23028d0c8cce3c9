// SPDX-License-Identifier: MIT
// Tables of the wrong shape or content, what is only a warning, and messages. Other faults are rows
// of bundle_faults.json.
#include "bundle_example.h"
#include "bundle_surgery.h"

#include <catch2/catch.hpp>

using namespace lichen;
using example::GlbParts;

namespace {

// In example::everyMap(), noise 0 is "felt" with a height map on tables 0 and 1. Noise 1 is "moss"
// with base colour (tables 2, 3), normal (4, 5), occlusion-roughness-metallic (6, 7) opacity (8)
// and emissive (9, 10).
const std::vector<std::byte>& soundFile() {
  static const std::vector<std::byte> file = encodeGlb(example::everyMap()).value();
  return file;
}

} // namespace

TEST_CASE("every Gaussian image or inverse table of the wrong shape or content is an error") {
  using enum TexelFormat;
  constexpr std::size_t color = 0, normal = 1, grey = 2; // maps of "moss"
  const auto gaussian = [](BundleFile& f, std::size_t map) -> Table& {
    return f.bundle.tables[f.bundle.noises[1].maps[map].as<TilingMap>().gaussian];
  };
  const auto inverse = [](BundleFile& f, std::size_t map) -> Table& {
    return f.bundle.tables[*f.bundle.noises[1].maps[map].as<TilingMap>().inverseTable];
  };
  const auto shaped = [](TexelFormat format, std::uint32_t width, std::uint32_t height,
                         std::uint32_t depth, std::uint32_t mips) {
    return example::patternTable("", format, width, height, depth, mips);
  };
  const auto withLosses = [&](std::vector<float> losses) {
    return [=](BundleFile& f) { example::setLosses(gaussian(f, grey), losses); };
  };
  struct Case {
    const char* message;
    std::function<void(BundleFile&)> make;
  };
  const std::vector<Case> cases{
      {"mip level 1 of the image has different values in its last channel",
       [&](BundleFile& f) {
         // One bit of one loss, of the last texel of level 1.
         Table& table = gaussian(f, color);
         const LevelRange range = levelRange(table, 1);
         table.texels[range.offset + range.size - 1] ^= std::byte(1);
       }},
      {"mip level 2 of the image has the loss 0.125 in its last channel; expected 0.25 to 1",
       withLosses({0.0f, 0.25f, 0.125f, 0.5f})},
      {"mip level 0 of the image has the loss -0.125 in its last channel; expected 0.0 to 1",
       withLosses({-0.125f, 0.25f, 0.5f, 0.75f})},
      {"mip level 3 of the image has the loss 1.5 in its last channel; expected 0.5 to 1",
       withLosses({0.0f, 0.25f, 0.5f, 1.5f})},
      {"3 mip levels; expected the full chain of 4",
       [&](BundleFile& f) { gaussian(f, color) = shaped(rgba8Unorm, 8, 8, 0, 3); }},
      {"2 channels; expected 4 for 3 dimensions and the loss",
       [&](BundleFile& f) { gaussian(f, color) = example::gaussianTable("", rg8Unorm, 8, 8); }},
      {"1 channel; expected 2 for 1 dimension and the loss",
       [&](BundleFile& f) { gaussian(f, grey) = example::gaussianTable("", r16Sfloat, 8, 8); }},
      {"at least 3", // the slopes' variance
       [&](BundleFile& f) { inverse(f, normal) = shaped(rg16Sfloat, 64, 64, 1, 1); }},
      {"8-bit texels for the encoding slope",
       [&](BundleFile& f) { inverse(f, normal) = shaped(rgba8Unorm, 64, 64, 1, 1); }},
      {"expected a 3-D image with 3 equal sides",
       [&](BundleFile& f) { inverse(f, color) = shaped(rgba8Unorm, 32, 32, 16, 1); }},
      {"expected a 3-D image with 3 equal sides",
       [&](BundleFile& f) { inverse(f, color) = shaped(rgba8Unorm, 24, 24, 24, 1); }},
      {"expected a 3-D image with 3 equal sides",
       [&](BundleFile& f) { inverse(f, color) = shaped(rgba8Unorm, 2, 2, 2, 1); }},
      {"expected a 3-D image with 1 equal side",
       [&](BundleFile& f) { inverse(f, grey) = shaped(rgba8Unorm, 512, 1, 1, 1); }},
      {"expected a 3-D image with 1 equal side",
       [&](BundleFile& f) { inverse(f, grey) = shaped(rgba8Unorm, 256, 1, 2, 1); }},
      {"expected a 3-D image with 2 equal sides",
       [&](BundleFile& f) { inverse(f, normal) = shaped(rgba16Sfloat, 64, 64, 0, 1); }},
      {"6 mip levels; expected at most 5 for a side of 256",
       [&](BundleFile& f) { inverse(f, grey) = shaped(rgba8Unorm, 256, 1, 1, 6); }},
      {"3 mip levels; expected at most 2 for a side of 4",
       [&](BundleFile& f) { inverse(f, color) = shaped(rgba8Unorm, 4, 4, 4, 3); }},
  };
  for (const Case& wrong : cases) {
    INFO(wrong.message);
    BundleFile file = example::everyMap();
    REQUIRE(encodeGlb(file));
    wrong.make(file);
    const Result<std::vector<std::byte>> refused = encodeGlb(file); // the checker reports it first
    REQUIRE_FALSE(refused);
    INFO(refused.error().message);
    CHECK(refused.error().message.find(wrong.message) != std::string::npos);
  }
}

TEST_CASE("an inverse table may have fewer cells and fewer mip levels than the largest") {
  BundleFile file = example::everyMap();
  const std::size_t table = *file.bundle.noises[1].maps[0].as<TilingMap>().inverseTable;
  for (const auto& [side, mips] : {std::pair{4u, 1u}, {4u, 2u}, {16u, 4u}, {64u, 5u}, {32u, 1u}}) {
    file.bundle.tables[table] =
        example::patternTable("", TexelFormat::rgba8Unorm, side, side, side, mips);
    CHECK(encodeGlb(file).ok());
  }
}

TEST_CASE("a harmless oddity is a warning and does not stop reading") {
  const auto warningOf = [](const std::function<void(GlbParts&)>& change) {
    GlbParts parts(soundFile());
    change(parts);
    const std::vector<std::byte> file = parts.join();
    CHECK(parseBundle(file, "odd.glb").ok());
    const std::vector<Finding> findings = checkBundle(file);
    REQUIRE(findings.size() == 1);
    CHECK(findings[0].severity == Finding::Severity::warning);
    return findings[0].code;
  };
  CHECK(warningOf([](GlbParts& p) { p.extension()["colour"] = 1; }) == "unknown-property");
  CHECK(warningOf([](GlbParts& p) { p.map(1, 0)["gausian"] = 1; }) == "unknown-property");
  CHECK(warningOf([](GlbParts& p) { p.use(0)["sharpness"] = 1; }) == "unknown-property");
  CHECK(warningOf([](GlbParts& p) {
          p.json["materials"][0]["extensions"]["KHR_materials_unlit"] = nlohmann::json::object();
        }) == "material-unlit");
  CHECK(warningOf([](GlbParts& p) {
          p.use(0)["mix"] = {{"source", "constant"}, {"weight", 0.5}};
        }) == "mix-without-steps");
  CHECK(warningOf([](GlbParts& p) { p.extension()["noises"][1]["maps"].erase(3); }) ==
        "table-unused");
  CHECK(warningOf([](GlbParts& p) {
          p.json.erase("extensions");
          p.json.erase("extensionsUsed");
          p.json.erase("materials");
        }) == "extension-absent");
}

TEST_CASE("a message has the singular for one value") {
  GlbParts parts(soundFile());
  parts.map(1, 0)["mean"] = nlohmann::json::array({0.5});
  const std::vector<Finding> findings = checkBundle(parts.join());
  REQUIRE_FALSE(findings.empty());
  CHECK(findings.front().message.starts_with("1 value; expected 3"));
}

TEST_CASE("the number of reported faults is limited") {
  GlbParts parts(soundFile());
  parts.json["materials"] = nlohmann::json::array();
  for (int i = 0; i < 60000; ++i)
    parts.json["materials"].push_back({{"extensions", {{std::string(kExtensionName), 1}}}});
  CHECK(checkBundle(parts.join()).size() <= 1000);
  parts.json["materials"] = std::vector<int>(70000, 0);
  CHECK_FALSE(parseBundle(parts.join(), "many.glb").ok());
}
