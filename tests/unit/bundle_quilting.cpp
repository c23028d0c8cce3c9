// SPDX-License-Identifier: MIT
// Quilting noises in a file: faults of their images, and what is written only if there is one.
// Other faults are rows of bundle_faults.json.
#include "bundle_example.h"
#include "bundle_faults.h"

#include <lichen/shader_parameters.h>

#include <catch2/catch.hpp>

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

/// The height as log2, in an image of one value.
void setLog2(GlbParts& parts, TexelFormat format, float value) {
  replaceTable(parts, kHeight, example::constantTable(format, 4, value));
  parts.map(0, 0)["encoding"] = "log2";
}

} // namespace

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

TEST_CASE("every fault of quilting's images is found") {
  using enum TexelFormat;
  Table blurred = example::smallestQuilting().bundle.tables[kCells];
  blurred.texels[2] = std::byte{127}; // the blue of one texel
  const struct {
    const char* what;
    const char* code;
    std::size_t index;
    Table table;
  } cases[] = {
      {"cells beyond 1", "map-quilting-texels", kCells,
       example::constantTable(rgba16Sfloat, 4, 1.5f)},
      {"two sharpnesses in a level", "map-quilting-sharpness", kCells, blurred},
      {"an image without its last level", "map-quilting", kHeight,
       example::patternTable("", r8Unorm, 4, 4, 0, 2)},
      {"cells without their last level", "map-quilting", kCells,
       example::patternTable("", rgba8Unorm, 4, 4, 0, 2)},
      {"a 3-D image", "map-quilting", kHeight, example::patternTable("", r8Unorm, 4, 4, 4, 3)},
      {"two channels for a height", "map-quilting", kHeight,
       example::constantTable(rg8Unorm, 4, 0.5f)},
      {"slopes without their squares", "map-quilting", kNormal,
       example::constantTable(rg16Sfloat, 4, 0.5f)},
      {"slopes in 8 bits", "map-quilting", kNormal, example::constantTable(rgba8Unorm, 4, 0.5f)},
      {"huge slopes", "map-quilting-texels", kNormal,
       example::constantTable(rgba32Sfloat, 4, 65505.0f)},
  };
  for (const auto& one : cases) {
    GlbParts parts(soundFile());
    replaceTable(parts, one.index, one.table);
    example::checkFault(one.what, one.code, parts);
  }
  GlbParts coarse(soundFile()), huge(soundFile());
  setLog2(coarse, r8Unorm, 0.5f);
  example::checkFault("a height of log2 in 8 bits", "map-quilting", coarse);
  setLog2(huge, r16Sfloat, 16.5f);
  example::checkFault("a huge height of log2", "map-quilting-texels", huge);
}

TEST_CASE("the largest texels are read, of log2 and of others") {
  GlbParts parts(soundFile());
  replaceTable(parts, kNormal,
               example::constantTable(TexelFormat::rgba32Sfloat, 4, kMostQuiltingTexel));
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
