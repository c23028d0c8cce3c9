// SPDX-License-Identifier: MIT
// A table of broken bundles. Each is a valid file with one fault, made by editing its JSON or its
// bytes: the checker must report the fault by its code, and the reader must reject the file.
#include "bundle_example.h"
#include "bundle_faults.h"

#include <catch2/catch.hpp>

using namespace lichen;
using example::GlbParts;

namespace {

// In example::everyMap(), noise 0 is "felt" with a height map on tables 0 and 1. Noise 1 is "moss"
// with base colour (tables 2, 3), normal (4, 5), occlusion-roughness-metallic (6, 7) and opacity
// (8).
const std::vector<std::byte>& soundFile() {
  static const std::vector<std::byte> file = encodeGlb(example::everyMap()).value();
  return file;
}

void checkFaults(const std::vector<example::Fault>& faults) {
  example::checkFaults(soundFile(), faults);
}

} // namespace

TEST_CASE("the example file has no faults before they are inserted") {
  CHECK(checkBundle(GlbParts(soundFile()).join()).empty());
}

TEST_CASE("every fault in the extension's root and lists is found") {
  checkFaults({
      {"not in extensionsUsed", "extensions-used",
       [](GlbParts& p) { p.json["extensionsUsed"] = {"KHR_texture_transform"}; }},
      {"no extensionsUsed", "extensions-used", [](GlbParts& p) { p.json.erase("extensionsUsed"); }},
      {"required", "extensions-required",
       [](GlbParts& p) { p.json["extensionsRequired"].push_back(kExtensionName); }},
      {"root is a list", "type", [](GlbParts& p) { p.extension() = nlohmann::json::array(); }},
      {"no root although materials use it", "noise-index",
       [](GlbParts& p) { p.json.erase("extensions"); }},
      {"no tables", "required", [](GlbParts& p) { p.extension().erase("tables"); }},
      {"empty noises", "count",
       [](GlbParts& p) { p.extension()["noises"] = nlohmann::json::array(); }},
      {"tables is an object", "type",
       [](GlbParts& p) { p.extension()["tables"] = nlohmann::json::object(); }},
      {"materials is a number", "count", [](GlbParts& p) { p.json["materials"] = 3; }},
      {"glTF 1.0", "asset-version", [](GlbParts& p) { p.json["asset"]["version"] = "1.0"; }},
      {"no asset", "asset-version", [](GlbParts& p) { p.json.erase("asset"); }},
  });
}

TEST_CASE("every fault in the reference to a table is found") {
  checkFaults({
      {"view out of range", "buffer-view",
       [](GlbParts& p) { p.extension()["tables"][0]["bufferView"] = 4000; }},
      {"negative view", "buffer-view",
       [](GlbParts& p) { p.extension()["tables"][0]["bufferView"] = -1; }},
      {"huge view", "buffer-view",
       [](GlbParts& p) { p.extension()["tables"][0]["bufferView"] = 18446744073709551615u; }},
      {"view as text", "type", [](GlbParts& p) { p.extension()["tables"][0]["bufferView"] = "0"; }},
      {"fractional view", "type",
       [](GlbParts& p) { p.extension()["tables"][0]["bufferView"] = 0.5; }},
      {"no view", "required", [](GlbParts& p) { p.extension()["tables"][0].erase("bufferView"); }},
      {"no MIME type", "required",
       [](GlbParts& p) { p.extension()["tables"][0].erase("mimeType"); }},
      {"another MIME type", "table-mime-type",
       [](GlbParts& p) { p.extension()["tables"][0]["mimeType"] = "image/png"; }},
      {"name is a number", "type", [](GlbParts& p) { p.extension()["tables"][0]["name"] = 1; }},
      {"table is null", "type", [](GlbParts& p) { p.extension()["tables"][0] = nullptr; }},
      {"view begins outside its buffer", "buffer-view",
       [](GlbParts& p) { p.json["bufferViews"][0]["byteOffset"] = 1u << 30u; }},
      {"view ends outside its buffer", "buffer-view",
       [](GlbParts& p) { p.json["bufferViews"][0]["byteLength"] = 1u << 30u; }},
      {"view's end overflows", "buffer-view",
       [](GlbParts& p) {
         p.json["bufferViews"][0]["byteOffset"] = 16;
         p.json["bufferViews"][0]["byteLength"] = 18446744073709551615u;
       }},
      {"view has a stride", "buffer-view",
       [](GlbParts& p) { p.json["bufferViews"][0]["byteStride"] = 4; }},
      {"view of an absent buffer", "buffer-view",
       [](GlbParts& p) { p.json["bufferViews"][0]["buffer"] = 7; }},
      {"no buffers", "buffer-view", [](GlbParts& p) { p.json.erase("buffers"); }},
      {"buffer longer than its chunk", "buffer",
       [](GlbParts& p) { p.json["buffers"][0]["byteLength"] = 1u << 30u; }},
      {"buffer without a length", "buffer",
       [](GlbParts& p) { p.json["buffers"][0].erase("byteLength"); }},
      {"second buffer without a URI", "buffer",
       [](GlbParts& p) {
         p.json["buffers"].push_back({{"byteLength", 16}});
         p.json["bufferViews"][0]["buffer"] = 1;
       }},
      {"buffer in a file, read from memory", "buffer-uri",
       [](GlbParts& p) { p.json["buffers"][0]["uri"] = "other.bin"; }},
      {"buffer on the network", "buffer-uri",
       [](GlbParts& p) { p.json["buffers"][0]["uri"] = "https://example.org/a.bin"; }},
      {"buffer in bad base64", "buffer-uri",
       [](GlbParts& p) { p.json["buffers"][0]["uri"] = "data:;base64,!!!!"; }},
      {"tables that share their bytes", "table-overlap",
       [](GlbParts& p) {
         for (int copies = 0; copies < 4; ++copies)
           p.extension()["tables"].push_back(p.extension()["tables"][7]);
         for (int copies = 0; copies < 200; ++copies)
           p.extension()["tables"].push_back(p.extension()["tables"][3]);
       }},
  });
}

TEST_CASE("every fault inside a KTX2 table is found") {
  // Offsets from the specification: header fields from 12 on, level index from 80, then descriptor.
  checkFaults({
      {"identifier", "table-ktx2", [](GlbParts& p) { p.setTableWord(0, 0, 0); }},
      {"unknown vkFormat", "table-ktx2", [](GlbParts& p) { p.setTableWord(0, 12, 131); }},
      {"vkFormat of other channels", "table-ktx2", [](GlbParts& p) { p.setTableWord(0, 12, 16); }},
      {"typeSize", "table-ktx2", [](GlbParts& p) { p.setTableWord(0, 16, 2); }},
      {"zero width", "table-ktx2", [](GlbParts& p) { p.setTableWord(0, 20, 0); }},
      {"huge width", "table-ktx2", [](GlbParts& p) { p.setTableWord(0, 20, 0xffffffffu); }},
      {"another height", "table-ktx2", [](GlbParts& p) { p.setTableWord(0, 24, 4); }},
      {"a depth", "table-ktx2", [](GlbParts& p) { p.setTableWord(0, 28, 2); }},
      {"huge depth", "table-ktx2", [](GlbParts& p) { p.setTableWord(3, 28, 0x80000000u); }},
      {"layers", "table-ktx2", [](GlbParts& p) { p.setTableWord(0, 32, 1); }},
      {"a cube", "table-ktx2", [](GlbParts& p) { p.setTableWord(0, 36, 6); }},
      {"no levels", "table-ktx2", [](GlbParts& p) { p.setTableWord(0, 40, 0); }},
      {"too many levels", "table-ktx2", [](GlbParts& p) { p.setTableWord(0, 40, 4); }},
      {"supercompression", "table-ktx2", [](GlbParts& p) { p.setTableWord(0, 44, 2); }},
      {"descriptor elsewhere", "table-ktx2", [](GlbParts& p) { p.setTableWord(0, 48, 0); }},
      {"descriptor past the end", "table-ktx2",
       [](GlbParts& p) { p.setTableWord(0, 52, 0xfffffff0u); }},
      {"key/value data elsewhere", "table-ktx2", [](GlbParts& p) { p.setTableWord(0, 56, 4); }},
      {"key/value data past the end", "table-ktx2",
       [](GlbParts& p) { p.setTableWord(0, 60, 0xfffffff0u); }},
      {"global data", "table-ktx2", [](GlbParts& p) { p.setTableWord(0, 64, 1); }},
      {"level elsewhere", "table-ktx2", [](GlbParts& p) { p.setTableWord(0, 80, 0); }},
      {"level far away", "table-ktx2", [](GlbParts& p) { p.setTableWord(0, 84, 0x80000000u); }},
      {"level length", "table-ktx2", [](GlbParts& p) { p.setTableWord(0, 88, 7); }},
      {"uncompressed length", "table-ktx2", [](GlbParts& p) { p.setTableWord(0, 96, 9); }},
      {"descriptor's colour model", "table-ktx2",
       [](GlbParts& p) { p.setTableWord(1, 80 + 24 + 12, 0x00010102u); }},
      {"key/value length", "table-ktx2",
       [](GlbParts& p) { p.setTableWord(1, 80 + 24 + 44, 0xffffffffu); }},
      {"NaN in half floats", "table-ktx2",
       [](GlbParts& p) {
         const std::size_t view = p.extension()["tables"][5]["bufferView"];
         const std::size_t length = p.json["bufferViews"][view]["byteLength"];
         p.setTableWord(5, length - 4, 0x7e007e00u);
       }},
      {"infinity in floats", "table-ktx2",
       [](GlbParts& p) {
         const std::size_t view = p.extension()["tables"][6]["bufferView"];
         const std::size_t length = p.json["bufferViews"][view]["byteLength"];
         p.setTableWord(6, length - 4, 0x7f800000u);
       }},
      {"bytes after the last level", "table-ktx2",
       [](GlbParts& p) {
         const std::size_t length = p.json["bufferViews"][0]["byteLength"];
         p.json["bufferViews"][0]["byteLength"] = length + 4;
       }},
      {"a byte too few", "table-ktx2",
       [](GlbParts& p) {
         const std::size_t length = p.json["bufferViews"][0]["byteLength"];
         p.json["bufferViews"][0]["byteLength"] = length - 1;
       }},
  });
}

TEST_CASE("every fault of a noise is found") {
  const auto noise = [](GlbParts& p) -> nlohmann::json& { return p.extension()["noises"][1]; };
  checkFaults({
      {"no name", "required", [=](GlbParts& p) { noise(p).erase("name"); }},
      {"name of another", "noise-name-duplicate", [=](GlbParts& p) { noise(p)["name"] = "felt"; }},
      {"method is a number", "type", [=](GlbParts& p) { noise(p)["method"] = 1; }},
      {"revision 0", "noise-revision", [=](GlbParts& p) { noise(p)["revision"] = 0; }},
      {"negative revision", "range", [=](GlbParts& p) { noise(p)["revision"] = -1; }},
      {"no tile", "range", [=](GlbParts& p) { noise(p)["tileSize"] = 0; }},
      {"huge tile", "range", [=](GlbParts& p) { noise(p)["tileSize"] = 1e300; }},
      {"no maps", "count", [=](GlbParts& p) { noise(p)["maps"] = nlohmann::json::array(); }},
      {"two maps of one target", "map-target-duplicate",
       [=](GlbParts& p) { noise(p)["maps"].push_back(noise(p)["maps"][0]); }},
      {"more maps than targets", "count",
       [=](GlbParts& p) {
         for (int copies = 0; copies < 3; ++copies)
           noise(p)["maps"].push_back(noise(p)["maps"][0]);
       }},
  });
}

TEST_CASE("every fault of a map's description is found") {
  checkFaults({
      {"unknown target", "map-target", [](GlbParts& p) { p.map(1, 0)["target"] = "colour"; }},
      {"unknown channel", "map-channels",
       [](GlbParts& p) { p.map(1, 0)["channels"][0] = "rouge"; }},
      {"channels of another target", "map-channels",
       [](GlbParts& p) {
         p.map(1, 0)["channels"] = {"slopeX", "slopeY"};
       }},
      {"channels out of order", "map-channels",
       [](GlbParts& p) {
         p.map(1, 2)["channels"] = {"metallic", "roughness", "occlusion"};
       }},
      {"a channel twice", "map-channels",
       [](GlbParts& p) {
         p.map(1, 2)["channels"] = {"roughness", "roughness", "metallic"};
       }},
      {"unknown encoding", "map-encoding", [](GlbParts& p) { p.map(1, 0)["encoding"] = "hsv"; }},
      {"slopes in sRGB", "map-encoding", [](GlbParts& p) { p.map(1, 1)["encoding"] = "srgb"; }},
      {"short mean", "map-mean",
       [](GlbParts& p) {
         p.map(1, 0)["mean"] = {0.5, 0.5};
       }},
      {"mean out of range", "range", [](GlbParts& p) { p.map(1, 0)["mean"][0] = 2.0; }},
      {"mean of text", "type", [](GlbParts& p) { p.map(1, 0)["mean"][0] = "NaN"; }},
      {"mean of null, as NaN prints", "type",
       [](GlbParts& p) { p.map(1, 0)["mean"][0] = nullptr; }},
      {"no covariance", "required", [](GlbParts& p) { p.map(1, 0).erase("covariance"); }},
      {"short covariance", "map-covariance",
       [](GlbParts& p) { p.map(1, 0)["covariance"].erase(8); }},
      {"lopsided covariance", "map-covariance",
       [](GlbParts& p) { p.map(1, 0)["covariance"][1] = 0.004; }},
      {"negative variance", "map-covariance",
       [](GlbParts& p) { p.map(0, 0)["covariance"] = {-0.01}; }},
      {"indefinite covariance", "map-covariance",
       [](GlbParts& p) {
         p.map(1, 1)["covariance"] = {0.01, 0.02, 0.02, 0.01};
       }},
      {"a level off its formula", "map-levels",
       [](GlbParts& p) { p.map(1, 2)["levels"][1] = 0.5; }},
      {"one level", "map-levels", [](GlbParts& p) { p.map(0, 0)["levels"] = {0.0}; }},
      {"levels without a table", "map-levels",
       [](GlbParts& p) {
         p.map(1, 3)["levels"] = {0.0, 1.0};
       }},
      {"a table without levels", "required", [](GlbParts& p) { p.map(0, 0).erase("levels"); }},
      {"mip losses for other mips", "map-mip-loss",
       [](GlbParts& p) { p.map(1, 0)["mipLoss"].push_back(1.0); }},
      {"falling mip losses", "map-mip-loss", [](GlbParts& p) { p.map(1, 0)["mipLoss"][2] = 0.01; }},
      {"mip loss above 1", "range", [](GlbParts& p) { p.map(1, 0)["mipLoss"][3] = 1.5; }},
      {"a loss at level 0", "map-mip-loss", [](GlbParts& p) { p.map(1, 0)["mipLoss"][0] = 0.01; }},
      {"huge list", "count",
       [](GlbParts& p) { p.map(1, 0)["mean"] = std::vector<double>(100000, 0.5); }},
  });
}

TEST_CASE("every contradiction between a map and its tables is found") {
  checkFaults({
      {"Gaussian index out of range", "map-gaussian-index",
       [](GlbParts& p) { p.map(1, 0)["gaussian"] = 99; }},
      {"inverse index out of range", "map-inverse-table-index",
       [](GlbParts& p) { p.map(1, 0)["inverseTable"] = 99; }},
      {"Gaussian image is 3-D", "map-gaussian", [](GlbParts& p) { p.map(1, 0)["gaussian"] = 3; }},
      {"Gaussian image without its mips", "map-gaussian",
       [](GlbParts& p) { p.map(0, 0)["gaussian"] = 1; }},
      {"more dimensions than channels", "map-gaussian",
       [](GlbParts& p) { p.map(0, 0)["gaussian"] = 2; }},
      {"fewer dimensions than channels without a table", "map-gaussian",
       [](GlbParts& p) {
         p.map(1, 2).erase("inverseTable");
         p.map(1, 2).erase("levels");
       }},
      {"inverse table with mips", "map-inverse-table",
       [](GlbParts& p) { p.map(0, 0)["inverseTable"] = 0; }},
      {"inverse table of too few channels", "map-inverse-table",
       [](GlbParts& p) { p.map(1, 0)["inverseTable"] = 1; }},
      {"inverse table of another shape", "map-inverse-table",
       [](GlbParts& p) { p.map(1, 2)["inverseTable"] = 3; }},
      {"slopes in 8 bits", "map-inverse-table",
       [](GlbParts& p) { p.map(1, 1)["inverseTable"] = 3; }},
      {"a singular covariance without a table", "map-covariance",
       [](GlbParts& p) { p.map(1, 3)["covariance"] = {0.0}; }},
      {"other levels than slabs", "map-inverse-table",
       [](GlbParts& p) { p.map(1, 0)["levels"] = example::levels(3); }},
  });
}

TEST_CASE("a table of slopes without their variance is an error") {
  BundleFile file = example::everyMap();
  REQUIRE(encodeGlb(file));
  const std::size_t table = *file.bundle.noises[1].maps[1].as<TilingMap>().inverseTable;
  file.bundle.tables[table] = example::patternTable("", TexelFormat::rg16Sfloat, 64, 192, 0, 1);
  const Result<std::vector<std::byte>> refused = encodeGlb(file); // the checker reports it first
  REQUIRE_FALSE(refused);
  CHECK(refused.error().message.find("at least 3") != std::string::npos);
}

TEST_CASE("every fault of a material's use is found") {
  checkFaults({
      {"noise out of range", "noise-index", [](GlbParts& p) { p.use(0)["noise"] = 2; }},
      {"no noise", "required", [](GlbParts& p) { p.use(0).erase("noise"); }},
      {"use is a string", "type", [](GlbParts& p) { p.use(0) = "felt"; }},
      {"unknown mapping", "material-mapping", [](GlbParts& p) { p.use(0)["mapping"] = "sphere"; }},
      {"unknown space", "material-space",
       [](GlbParts& p) {
         p.use(0)["mapping"] = "triplanar";
         p.use(0)["space"] = "tangent";
       }},
      {"a space without a mapping in space", "material-space",
       [](GlbParts& p) {
         p.use(0).erase("mapping");
         p.use(0)["space"] = "object";
       }},
      {"a mapping that tiling lacks", "material-mapping",
       [](GlbParts& p) { p.use(0)["mapping"] = "solid"; }},
      {"texture coordinates out of range", "range", [](GlbParts& p) { p.use(0)["texCoord"] = 16; }},
      {"no scale", "range", [](GlbParts& p) { p.use(0)["scale"] = 0.0; }},
      {"negative scale", "range", [](GlbParts& p) { p.use(0)["scale"] = -1.0; }},
      {"one offset", "count", [](GlbParts& p) { p.use(0)["offset"] = {0.0}; }},
      {"three offsets", "count",
       [](GlbParts& p) {
         p.use(0)["offset"] = {0.0, 0.0, 0.0};
       }},
      {"rotation of text", "type", [](GlbParts& p) { p.use(0)["rotation"] = "90"; }},
      {"seed beyond 32 bits", "range", [](GlbParts& p) { p.use(0)["seed"] = 4294967296; }},
      {"negative seed", "range", [](GlbParts& p) { p.use(0)["seed"] = -1; }},
      {"blunt weights", "range", [](GlbParts& p) { p.use(0)["blendSharpness"] = 0.1; }},
      {"blunt planes", "range", [](GlbParts& p) { p.use(0)["planeSharpness"] = 0.9; }},
      {"more steps than the hash has", "range",
       [](GlbParts& p) { p.use(0)["tileRotation"] = 65537; }},
      {"negative steps", "range", [](GlbParts& p) { p.use(0)["tileRotation"] = -1; }},
      {"half a step", "type", [](GlbParts& p) { p.use(0)["tileRotation"] = 2.5; }},
      {"steps of text", "type", [](GlbParts& p) { p.use(0)["tileRotation"] = "free"; }},
      {"too much contrast", "range", [](GlbParts& p) { p.use(0)["contrast"] = 5.0; }},
  });
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
  parts.map(0, 0)["levels"] = nlohmann::json::array({0.0});
  const std::vector<Finding> findings = checkBundle(parts.join());
  REQUIRE_FALSE(findings.empty());
  CHECK(findings.front().message.starts_with("1 value; expected 2 to "));
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
