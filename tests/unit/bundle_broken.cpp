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
// with base colour (tables 2, 3), normal (4, 5), occlusion-roughness-metallic (6, 7) opacity (8)
// and emissive (9, 10).
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
      {"vkFormat of other channels", "table-ktx2", [](GlbParts& p) { p.setTableWord(0, 12, 9); }},
      {"codes of sRGB", "table-ktx2", [](GlbParts& p) { p.setTableWord(2, 12, 43); }},
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
         const std::size_t view = p.extension()["tables"][10]["bufferView"];
         const std::size_t length = p.json["bufferViews"][view]["byteLength"];
         p.setTableWord(10, length - 4, 0x7f800000u);
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
      {"a crop without height", "preparation-pixels",
       [=](GlbParts& p) {
         noise(p)["preparation"]["crop"] = {0, 0, 8, 0};
       }},
      {"a size of one number", "preparation-pixels",
       [=](GlbParts& p) { noise(p)["preparation"]["size"] = {8}; }},
      {"other normals", "preparation-choice",
       [=](GlbParts& p) { noise(p)["preparation"]["normals"] = "openGL"; }},
      {"periodic in text", "type",
       [=](GlbParts& p) { noise(p)["preparation"]["periodic"] = "no"; }},
      {"a place of three numbers", "preparation-pixels",
       [=](GlbParts& p) {
         noise(p)["preparation"]["filled"] =
             nlohmann::json::parse(R"([{"place": [0, 0, 8], "from": [8, 8]}])");
       }},
      {"a place filled from nowhere", "required",
       [=](GlbParts& p) {
         noise(p)["preparation"]["filled"] = nlohmann::json::parse(R"([{"place": [0, 0, 8, 8]}])");
       }},
      {"an unknown flattened map", "preparation-maps",
       [=](GlbParts& p) {
         noise(p)["preparation"]["flattened"] = {{"period", 8}, {"maps", {"h\u00f6he"}}};
       }},
      {"a grain along z", "noise-grain", [=](GlbParts& p) { noise(p)["grain"] = "z"; }},
      {"a grain of no axis", "noise-grain", [=](GlbParts& p) { noise(p)["grain"] = "none"; }},
      {"a grain that is a number", "type", [=](GlbParts& p) { noise(p)["grain"] = 1; }},
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
      {"slopes as roots", "map-encoding", [](GlbParts& p) { p.map(1, 1)["encoding"] = "root"; }},
      {"codes of files", "map-encoding", [](GlbParts& p) { p.map(1, 0)["encoding"] = "srgb"; }},
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
      {"no dimensions", "required", [](GlbParts& p) { p.map(1, 0).erase("dimensions"); }},
      {"0 dimensions", "range", [](GlbParts& p) { p.map(1, 0)["dimensions"] = 0; }},
      {"4 dimensions", "range", [](GlbParts& p) { p.map(1, 0)["dimensions"] = 4; }},
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
      {"more dimensions than channels", "map-dimensions",
       [](GlbParts& p) { p.map(0, 0)["dimensions"] = 2; }},
      {"fewer dimensions than channels without a table", "map-dimensions",
       [](GlbParts& p) { p.map(1, 2).erase("inverseTable"); }},
      {"other dimensions than the image has channels for", "map-gaussian",
       [](GlbParts& p) { p.map(1, 0)["dimensions"] = 1; }},
      {"inverse table is 2-D", "map-inverse-table",
       [](GlbParts& p) { p.map(0, 0)["inverseTable"] = 0; }},
      {"inverse table of too few channels", "map-inverse-table",
       [](GlbParts& p) { p.map(1, 0)["inverseTable"] = 1; }},
      {"inverse table of more dimensions", "map-inverse-table",
       [](GlbParts& p) { p.map(1, 2)["inverseTable"] = 3; }},
      {"slopes in 8 bits", "map-inverse-table",
       [](GlbParts& p) { p.map(1, 1)["inverseTable"] = 3; }},
      {"a singular covariance without a table", "map-covariance",
       [](GlbParts& p) { p.map(1, 3)["covariance"] = {0.0}; }},
  });
}

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
      {"tiles at three angles", "material-tile-rotation",
       [](GlbParts& p) { p.use(0)["tileRotation"] = 3; }},
      {"tiles at any angle", "material-tile-rotation",
       [](GlbParts& p) { p.use(0)["tileRotation"] = 65536; }},
      {"quarter turns of tiles that are not square", "material-tile-rotation",
       [](GlbParts& p) { p.use(0)["tileRotation"] = 4; }},
      {"a negative tile rotation", "material-tile-rotation",
       [](GlbParts& p) { p.use(0)["tileRotation"] = -1; }},
      {"tiles at 2.5 angles", "material-tile-rotation",
       [](GlbParts& p) { p.use(0)["tileRotation"] = 2.5; }},
      {"a tile rotation of text", "material-tile-rotation",
       [](GlbParts& p) { p.use(0)["tileRotation"] = "free"; }},
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
