// SPDX-License-Identifier: MIT
// Quilting noises in a file: every fault that the checker must report by its code and the reader
// must reject, and what the shader's constants hold of them.
#include "bundle_example.h"
#include "bundle_faults.h"

#include <lichen/shader_parameters.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>

using namespace lichen;
using example::GlbParts;
using nlohmann::json;

namespace {

const std::vector<std::byte>& soundFile() {
  static const std::vector<std::byte> file = encodeGlb(example::smallestQuilting()).value();
  return file;
}

json& noiseOf(GlbParts& parts) { return parts.extension()["noises"][0]; }

constexpr std::size_t kCells = 0, kHeight = 1, kNormal = 2; // the tables

/// Puts another table in place of one. The writer would refuse it.
void replaceTable(GlbParts& parts, std::size_t index, const Table& table) {
  const std::vector<std::byte> file = encodeKtx2(table);
  json& view =
      parts
          .json["bufferViews"][parts.extension()["tables"][index]["bufferView"].get<std::size_t>()];
  constexpr std::size_t kAlignment = 16;
  parts.binary.resize((parts.binary.size() + kAlignment - 1) / kAlignment * kAlignment);
  view["byteOffset"] = parts.binary.size();
  view["byteLength"] = file.size();
  parts.binary.insert(parts.binary.end(), file.begin(), file.end());
  parts.binary.resize((parts.binary.size() + kAlignment - 1) / kAlignment * kAlignment);
  parts.json["buffers"][0]["byteLength"] = parts.binary.size();
}

Table tableOf(TexelFormat format, std::uint32_t side, float value) {
  Table table = example::patternTable("", format, side, side, 0, example::fullMipChain(side, side));
  std::vector<float> values;
  for (std::uint32_t level = 0; level < table.mipLevels; ++level) {
    const std::vector<float> own = decodeLevel(table, level);
    values.resize(values.size() + own.size(), value);
  }
  table.texels.clear();
  appendTexels(table.texels, format, values);
  return table;
}

/// The height as log2, in an image of one value.
void setLog2(GlbParts& parts, TexelFormat format, float value) {
  replaceTable(parts, kHeight, tableOf(format, 4, value));
  parts.map(0, 0)["encoding"] = "log2";
}

} // namespace

TEST_CASE("the example file of quilting has no faults, and is read as it was written") {
  CHECK(checkBundle(GlbParts(soundFile()).join()).empty());
  const Bundle bundle = parseBundle(soundFile(), "quilting").value();
  REQUIRE(bundle.noises.size() == 1);
  CHECK(bundle.noises[0] == example::smallestQuilting().bundle.noises[0]);
}

TEST_CASE("a list of offsets is written only if there is one") {
  for (const bool hasList : {false, true}) {
    BundleFile file = example::smallestQuilting();
    if (!hasList)
      file.bundle.noises[0].as<QuiltingNoise>().offsets.clear();
    const std::vector<std::byte> glb = encodeGlb(file).value();
    CHECK(checkBundle(glb).empty());
    CHECK(parseBundle(glb, "quilting").value().noises[0] == file.bundle.noises[0]);
    GlbParts parts(glb);
    CHECK(noiseOf(parts).contains("offsets") == hasList);
  }
}

TEST_CASE("a grain of quilting is written only if there is one, and stretches the lattice") {
  struct Stretched {
    Grain grain;
    float columns, rows;
  };
  for (const auto& [grain, columns, rows] :
       {Stretched{Grain::none, 3.5f, 4.0f}, {Grain::x, 1.75f, 4.0f}, {Grain::y, 3.5f, 2.0f}}) {
    BundleFile file = example::smallestQuilting();
    file.bundle.noises[0].as<QuiltingNoise>().grain = grain;
    const std::vector<std::byte> glb = encodeGlb(file).value();
    CHECK(checkBundle(glb).empty());
    const Bundle bundle = parseBundle(glb, "quilting").value();
    CHECK(bundle.noises[0] == file.bundle.noises[0]);
    GlbParts parts(glb);
    CHECK(noiseOf(parts).value("grain", "none") == nameOf(grain));
    CHECK(noiseOf(parts).contains("grain") == (grain != Grain::none));
    MaterialNoise use;
    use.tileRotation = 4; // of tiling only
    const shader::LichenMaterial material = shaderMaterial(bundle, use, {}).material;
    CHECK(material.columnsPerTile == columns);
    CHECK(material.rowsPerTile == rows);
  }
}

TEST_CASE("every fault of what quilting's maps share is found") {
  const auto setOffset = [](json value) {
    return [value = std::move(value)](GlbParts& p) { noiseOf(p)["offsets"][3] = value; };
  };
  example::checkFaults(
      soundFile(),
      {
          {"no reach", "required", [](GlbParts& p) { noiseOf(p).erase("reach"); }},
          {"a reach of 0", "range", [](GlbParts& p) { noiseOf(p)["reach"] = 0; }},
          {"a reach beyond half a tile", "range", [](GlbParts& p) { noiseOf(p)["reach"] = 0.51; }},
          {"a reach in text", "type", [](GlbParts& p) { noiseOf(p)["reach"] = "0.1"; }},
          {"a grain along z", "noise-grain", [](GlbParts& p) { noiseOf(p)["grain"] = "z"; }},
          {"offsets in text", "type", [](GlbParts& p) { noiseOf(p)["offsets"] = "0"; }},
          {"no offset in a list", "count",
           [](GlbParts& p) { noiseOf(p)["offsets"] = json::array(); }},
          {"two offsets", "count",
           [](GlbParts& p) {
             noiseOf(p)["offsets"].erase(0);
             noiseOf(p)["offsets"].erase(0);
           }},
          {"25 offsets", "count",
           [](GlbParts& p) {
             noiseOf(p)["offsets"] = std::vector(25, std::array{0.5, 0.5});
           }},
          {"an offset of a whole tile", "range", setOffset({0.5, 1.0})},
          {"an offset below 0", "range", setOffset({-0.01, 0.5})},
          {"an offset of one number", "range", setOffset(json::array({0.5}))},
          {"an offset of three numbers", "range", setOffset({0.5, 0.5, 0.5})},
          {"an offset in text", "range", setOffset({"0.5", 0.5})},
          {"an offset that is a number", "range", setOffset(0.5)},
          {"on a surface", "material-mapping",
           [](GlbParts& p) { p.use(0)["mapping"] = "surface"; }},
          {"in a solid", "material-mapping", [](GlbParts& p) { p.use(0)["mapping"] = "solid"; }},
      });
}

TEST_CASE("every fault of quilting's images is found") {
  const auto with = [](std::size_t index, Table table) {
    return [index, table = std::move(table)](GlbParts& p) { replaceTable(p, index, table); };
  };
  Table blurred = example::smallestQuilting().bundle.tables[kCells];
  blurred.texels[2] = std::byte{127}; // the blue of one texel
  example::checkFaults(
      soundFile(),
      {
          {"no image", "required", [](GlbParts& p) { p.map(0, 0).erase("image"); }},
          {"no cells", "required", [](GlbParts& p) { p.map(0, 1).erase("cells"); }},
          {"no such image", "map-quilting-index", [](GlbParts& p) { p.map(0, 0)["image"] = 7; }},
          {"no such cells", "map-quilting-index", [](GlbParts& p) { p.map(0, 0)["cells"] = 7; }},
          {"cells as the image of a height", "map-quilting",
           [](GlbParts& p) { p.map(0, 0)["image"] = kCells; }},
          {"the image of a height as cells", "map-quilting",
           [](GlbParts& p) { p.map(0, 0)["cells"] = kHeight; }},
          {"cells beyond 1", "map-quilting-texels",
           with(kCells, tableOf(TexelFormat::rgba16Sfloat, 4, 1.5f))},
          {"two sharpnesses in a level", "map-quilting-sharpness", with(kCells, blurred)},
          {"an image without its last level", "map-quilting",
           with(kHeight, example::patternTable("", TexelFormat::r8Unorm, 4, 4, 0, 2))},
          {"cells without their last level", "map-quilting",
           with(kCells, example::patternTable("", TexelFormat::rgba8Unorm, 4, 4, 0, 2))},
          {"a 3-D image", "map-quilting",
           with(kHeight, example::patternTable("", TexelFormat::r8Unorm, 4, 4, 4, 3))},
          {"two channels for a height", "map-quilting",
           with(kHeight, tableOf(TexelFormat::rg8Unorm, 4, 0.5f))},
          {"slopes without their squares", "map-quilting",
           with(kNormal, tableOf(TexelFormat::rg16Sfloat, 4, 0.5f))},
          {"slopes in 8 bits", "map-quilting",
           with(kNormal, tableOf(TexelFormat::rgba8Unorm, 4, 0.5f))},
          {"huge slopes", "map-quilting-texels",
           with(kNormal, tableOf(TexelFormat::rgba32Sfloat, 4, 65505.0f))},
          {"a height of log2 in 8 bits", "map-quilting",
           [](GlbParts& p) { setLog2(p, TexelFormat::r8Unorm, 0.5f); }},
          {"a huge height of log2", "map-quilting-texels",
           [](GlbParts& p) { setLog2(p, TexelFormat::r16Sfloat, 16.5f); }},
      });
}

TEST_CASE("the largest texels are read, of log2 and of others") {
  GlbParts parts(soundFile());
  replaceTable(parts, kNormal, tableOf(TexelFormat::rgba32Sfloat, 4, kMostQuiltingTexel));
  CHECK(parseBundle(parts.join(), "slopes").ok());
  setLog2(parts, TexelFormat::r16Sfloat, kMostQuiltingLog2);
  CHECK(parseBundle(parts.join(), "log2").ok());
}

TEST_CASE("maps with images of cells of their own are refused") {
  BundleFile file = example::smallestQuilting();
  file.bundle.tables.push_back(file.bundle.tables[kCells]);
  GlbParts parts(encodeGlb(file).value());
  parts.map(0, 1)["cells"] = file.bundle.tables.size() - 1;
  const std::vector<Finding> findings = checkBundle(parts.join());
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].code == "map-quilting");
  CHECK(findings[0].message == "differs from the first map's; expected the same");
}

TEST_CASE("the constants of a quilting noise hold its reach, its offsets and the size of cells") {
  BundleFile file = example::smallestQuilting();
  constexpr double kBelowOne = 0.9999999; // rounds to a whole tile, which is none
  file.bundle.noises[0].as<QuiltingNoise>().offsets.push_back({kBelowOne, 0.25});
  file.bundle.tables[kCells] = tableOf(TexelFormat::rgba8Unorm, 8, 0.5f);
  const Bundle bundle = parseBundle(encodeGlb(file).value(), "quilting").value();
  const shader::LichenNoiseConstants constants = shaderConstants(bundle, 0);
  CHECK(constants.noise.method == LICHEN_METHOD_QUILTING);
  CHECK(constants.noise.tileTexelsX == 4.0f);
  const shader::LichenQuiltingNoise part = quiltingPart(constants.noise);
  CHECK(part.reach == 0.125f);
  CHECK(part.cellLevelOffset == 1.0f); // twice as wide as the map
  CHECK(part.offsets == 5);
  constexpr std::uint32_t kHalf = 0x8000, kQuarter = 0x4000;
  CHECK(constants.offsets[0].x == 0);
  CHECK(constants.offsets[0].y == kHalf);
  CHECK(constants.offsets[0].z == kHalf << 16u);
  CHECK(constants.offsets[0].w == (kHalf | kHalf << 16u));
  CHECK(constants.offsets[1].x == kQuarter << 16u);
  CHECK(constants.offsets[1].y == 0);
}

TEST_CASE("the constants of a quilting map have the mean of what its texels stand for") {
  const auto meanOf = [](ValueEncoding encoding, float value) {
    BundleFile file = example::smallestQuilting();
    file.bundle.tables[kHeight] = tableOf(TexelFormat::r16Sfloat, 4, value);
    file.bundle.noises[0].maps[0].encoding = encoding;
    return shaderMap(file.bundle, file.bundle.noises[0], 0).mean.x;
  };
  CHECK(meanOf(ValueEncoding::linear, 0.25f) == 0.25f);
  CHECK(meanOf(ValueEncoding::root, 0.25f) == 0.0625f);
  CHECK(meanOf(ValueEncoding::log2, 3.0f) == 7.0f);
  // Of slopes, the third is their variance, the mean of both axes.
  const Bundle bundle = example::smallestQuilting().bundle;
  const shader::LichenMap normal = shaderMap(bundle, bundle.noises[0], 1);
  CHECK(normal.decoding == LICHEN_DECODING_NONE);
  double sumX = 0.0, sumY = 0.0, squares = 0.0;
  const std::vector<float> texels = decodeLevel(bundle.tables[kNormal], 0);
  for (std::size_t i = 0; i < texels.size(); i += 4) {
    sumX += double(texels[i]);
    sumY += double(texels[i + 1]);
    squares +=
        double(texels[i]) * double(texels[i]) + double(texels[i + 1]) * double(texels[i + 1]);
  }
  const double count = double(texels.size()) / 4.0;
  const double meanX = sumX / count, meanY = sumY / count;
  constexpr double kHalfRounding = 1e-3;
  CHECK(normal.mean.x == Approx(meanX).margin(kHalfRounding));
  CHECK(normal.mean.y == Approx(meanY).margin(kHalfRounding));
  CHECK(normal.mean.z ==
        Approx((squares / count - meanX * meanX - meanY * meanY) / 2.0).margin(kHalfRounding));
}

TEST_CASE("a tile origin of quilting is one of the lattice, and the rest an offset") {
  const Bundle bundle = parseBundle(soundFile(), "quilting").value();
  Placement placement;
  placement.tileOriginX = 2 * 5 + 1;
  placement.tileOriginY = -3;
  const shader::LichenMaterial material =
      shaderMaterial(bundle, MaterialNoise(), placement).material;
  CHECK(material.cellI == 5 * 7 + 3 * 2);
  CHECK(material.offsetX == 1.0f);
  CHECK(material.cellJ == -3 * 4);
  CHECK(material.offsetY == 0.0f);
  CHECK(material.columnsPerTile == 3.5f);
  CHECK(material.rowsPerTile == 4.0f);
}
