// SPDX-License-Identifier: MIT
// The reader returns what the writer wrote, bit for bit.
#include "bundle_example.h"
#include "bundle_surgery.h"
#include "child_process.h"
#include "temporary_folder.h"

#include <lichen/bundle_files.h>
#include <lichen/bundle_merge.h>
#include <lichen/files.h>

#include <catch2/catch.hpp>

using namespace lichen;
using nlohmann::json;

namespace {

void checkSameTable(const Table& a, const Table& b) {
  CHECK(a.name == b.name);
  CHECK(a.format == b.format);
  CHECK(a.width == b.width);
  CHECK(a.height == b.height);
  CHECK(a.depth == b.depth);
  CHECK(a.mipLevels == b.mipLevels);
  CHECK(a.texels == b.texels);
}

void checkSameMap(const NoiseMap& a, const NoiseMap& b) {
  CHECK(a.target == b.target);
  CHECK(a.channels == b.channels);
  CHECK(a.encoding == b.encoding);
  CHECK(a.mean == b.mean);
  CHECK(a.covariance == b.covariance);
  CHECK(a.data == b.data);
}

void checkSameBundle(const Bundle& a, const Bundle& b) {
  REQUIRE(a.tables.size() == b.tables.size());
  for (std::size_t i = 0; i < a.tables.size(); ++i)
    checkSameTable(a.tables[i], b.tables[i]);
  REQUIRE(a.noises.size() == b.noises.size());
  for (std::size_t i = 0; i < a.noises.size(); ++i) {
    CHECK(a.noises[i].name == b.noises[i].name);
    CHECK(a.noises[i].tileSizeMetres == b.noises[i].tileSizeMetres);
    CHECK(a.noises[i].data == b.noises[i].data);
    CHECK(a.noises[i].preparation == b.noises[i].preparation);
    REQUIRE(a.noises[i].maps.size() == b.noises[i].maps.size());
    for (std::size_t m = 0; m < a.noises[i].maps.size(); ++m)
      checkSameMap(a.noises[i].maps[m], b.noises[i].maps[m]);
  }
  REQUIRE(a.materials.size() == b.materials.size());
  for (std::size_t i = 0; i < a.materials.size(); ++i) {
    REQUIRE(a.materials[i].has_value());
    REQUIRE(b.materials[i].has_value());
    const MaterialNoise& x = *a.materials[i];
    const MaterialNoise& y = *b.materials[i];
    CHECK(x.noise == y.noise);
    CHECK(x.mapping == y.mapping);
    CHECK(x.space == y.space);
    CHECK(x.texCoord == y.texCoord);
    CHECK(x.scale == y.scale);
    CHECK(x.offset == y.offset);
    CHECK(x.rotation == y.rotation);
    CHECK(x.seed == y.seed);
    CHECK(x.blendSharpness == y.blendSharpness);
    CHECK(x.planeSharpness == y.planeSharpness);
    CHECK(x.contrast == y.contrast);
    CHECK(x.tileRotation == y.tileRotation);
    CHECK(x.impacts == y.impacts);
    CHECK(x.pointProcess == y.pointProcess);
    CHECK(x.mix == y.mix);
  }
}

} // namespace

TEST_CASE("a table of every format survives the round trip through KTX2") {
  for (const TexelFormat format :
       {TexelFormat::r8Unorm, TexelFormat::rg8Unorm, TexelFormat::rgba8Unorm,
        TexelFormat::r16Sfloat, TexelFormat::rg16Sfloat, TexelFormat::rgba16Sfloat,
        TexelFormat::r32Sfloat, TexelFormat::rgba32Sfloat}) {
    for (const std::uint32_t mipLevels : {1u, 3u}) {
      const Table flat = example::patternTable("flat", format, 5, 7, 0, mipLevels);
      const auto decoded = decodeKtx2(encodeKtx2(flat), "flat");
      REQUIRE(decoded.ok());
      checkSameTable(decoded.value(), flat);
    }
    for (const std::uint32_t mipLevels : {1u, 3u}) {
      const Table deep = example::patternTable("deep", format, 3, 2, 5, mipLevels);
      const auto decoded = decodeKtx2(encodeKtx2(deep), "deep");
      REQUIRE(decoded.ok());
      checkSameTable(decoded.value(), deep);
    }
  }
}

TEST_CASE("a bundle survives the round trip through a GLB") {
  for (BundleFile file : {example::smallest(), example::everyMap(), example::smallestTexton(),
                          example::smallestCosines(), example::smallestKernels(),
                          example::smallestQuilting(), example::textonMix()}) {
    file.bundle.noises[0].preparation = {
        .crop = {{1, 2, 3, 4}},
        .size = {{5, 6}},
        .isGreenDown = true,
        .usesAlpha = true,
        .periodic = false,
        .flattenPeriod = 1.0 / 0.011,
        .flattened = {MapTarget::height, MapTarget::baseColor},
        .filled = {{{1, 2, 3, 4}, {5, 6}}, {{0, 0, 1, 1}, {}}},
        .corners = {{{{0.5, 1.25}, {30.0, 0.0}, {31.5, 30.0}, {0.0, 29.0}}}}};
    const auto glb = encodeGlb(file);
    if (!glb.ok())
      FAIL(glb.error().message);
    const auto bundle = parseBundle(glb.value(), "test");
    REQUIRE(bundle.ok());
    checkSameBundle(bundle.value(), file.bundle);
    CHECK(checkBundle(glb.value()).empty());
    CHECK(bundle.value().materialNames.size() == file.bundle.materials.size());
  }
}

TEST_CASE("a grain survives a GLB and a merge, and is written only if there is one") {
  for (const Grain grain : {Grain::none, Grain::x, Grain::y}) {
    BundleFile file = example::smallest();
    file.bundle.noises[0].as<TilingNoise>().grain = grain;
    const std::vector<std::byte> glb = encodeGlb(file).value();
    CHECK(checkBundle(glb).empty());
    const Bundle bundle = parseBundle(glb, "test").value();
    checkSameBundle(bundle, file.bundle);
    const Bundle other = parseBundle(encodeGlb(example::everyMap()).value(), "other").value();
    const std::vector<NamedBundle> inputs{{"other.glb", other}, {"file.glb", bundle}};
    CHECK(mergeBundles(inputs).value().bundle.noises.back().as<TilingNoise>().grain == grain);
    const json noise = example::GlbParts(glb).extension()["noises"][0];
    CHECK(noise.contains("grain") == (grain != Grain::none));
    CHECK(noise.value("grain", "none") == nameOf(grain));
  }
}

TEST_CASE("a merge notes the noises and the materials that get another name") {
  Bundle felt = example::smallest().bundle;
  felt.materialNames = {"sofa"};
  Bundle linen = felt;
  linen.noises[0].name = "linen";
  linen.noises[0].tileSizeMetres = 3.0;
  const std::vector<NamedBundle> inputs{{"felt.glb", felt}, {"linen.glb", linen}};
  const MergedBundle merged = mergeBundles(inputs).value();
  CHECK(merged.bundle.materialNames == std::vector<std::string>{"sofa", "sofa-2"});
  CHECK(merged.notes ==
        std::vector<std::string>{
            "linen.glb: material 'sofa' is named 'sofa-2', since another has that name"});
}

TEST_CASE("the same bundle gives the same bytes") {
  CHECK(encodeGlb(example::everyMap()).value() == encodeGlb(example::everyMap()).value());
}

TEST_CASE("files of both kinds are written, checked and read") {
  const TemporaryFolder folder;
  const BundleFile file = example::everyMap();
  for (const char* name : {"moss.glb", "moss.gltf", "50% moss & \xC3\xBC.gltf"}) {
    const std::filesystem::path path = folder.path() / name;
    const Result<void> written = writeBundle(path, file);
    if (!written)
      FAIL(written.error().message);
    const auto bundle = readBundle(path);
    if (!bundle)
      FAIL(bundle.error().message);
    checkSameBundle(bundle.value(), file.bundle);
    const auto findings = checkBundle(path);
    REQUIRE(findings.ok());
    CHECK(findings.value().empty());
  }
  const Result<void> refused = writeBundle(folder.path() / "moss.obj", file);
  REQUIRE_FALSE(refused.ok());
  CHECK(refused.error().kind == ErrorKind::usage);
}

TEST_CASE("a .gltf written over another removes the binary that only the old one named") {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "moss & b.gltf";
  const std::vector<std::byte> foreign(3);
  REQUIRE(replaceFile(folder.path() / "moss & b.bin", foreign).ok());
  REQUIRE(writeBundle(path, example::everyMap()).ok());
  REQUIRE(writeBundle(path, example::everyMap()).ok());
  CHECK(folder.entryCount() == 3);
  REQUIRE(writeBundle(path, example::smallest()).ok());
  CHECK(folder.entryCount() == 3);
  checkSameBundle(readBundle(path).value(), example::smallest().bundle);
}

TEST_CASE("replacing a .gltf keeps a binary that another program wrote") {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "moss.gltf";
  for (const char* uri : {"other.01234567.bin", "moss.bin", "moss.0123456g.bin", "moss.0123456.bin",
                          "moss.012345678.bin"}) {
    REQUIRE(replaceFile(folder.path() / uri, std::vector<std::byte>(3)).ok());
    const std::string text =
        R"({"asset": {"version": "2.0"}, "buffers": [{"uri": ")" + std::string(uri) + R"("}]})";
    REQUIRE(replaceFile(path, std::as_bytes(std::span(text))).ok());
    REQUIRE(writeBundle(path, example::smallest()).ok());
    CHECK(std::filesystem::exists(folder.path() / uri));
  }
}

TEST_CASE("a disk that is full between the two files of a .gltf leaves only the old pair") {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "moss.gltf";
  REQUIRE(writeBundle(path, example::everyMap()).ok());
  BundleFile longText = example::smallest();
  longText.generator = std::string(200000, 'x');
  const int status = childStatus([&] {
    if (!limitFiles(100000))
      return 100;
    const Result<void> result = writeBundle(path, longText);
    const bool ofText = !result && result.error().kind == ErrorKind::resources &&
                        result.error().message.starts_with(path.string() + ": cannot be written");
    return ofText ? 0 : 1;
  });
  CHECK(status == 0);
  checkSameBundle(readBundle(path).value(), example::everyMap().bundle);
  CHECK(folder.entryCount() == 2);
}
