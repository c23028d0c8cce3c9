// SPDX-License-Identifier: MIT
// The container of a bundle: GLB framing, JSON limits, data URIs, and files next to a .gltf.
#include "bundle/data_uri.h"
#include "bundle/gltf_container.h"
#include "bundle_example.h"
#include "bundle_surgery.h"
#include "temporary_folder.h"

#include <lichen/base64.h>
#include <lichen/bundle_files.h>
#include <lichen/files.h>

#include <catch2/catch.hpp>

#include <cstring>
#include <numeric>

using namespace lichen;
using example::GlbParts;

namespace {

std::vector<std::byte> smallFile() { return encodeGlb(example::smallest()).value(); }

std::string codeOf(std::span<const std::byte> file) {
  const std::vector<Finding> findings = checkBundle(file);
  CHECK_FALSE(parseBundle(file, "x").ok());
  return findings.empty() ? "" : findings.front().code;
}

std::string codeOfText(const std::string& text) { return codeOf(std::as_bytes(std::span(text))); }

void writeText(const std::filesystem::path& path, const std::string& text) {
  REQUIRE(replaceFile(path, std::as_bytes(std::span(text))).ok());
}

} // namespace

TEST_CASE("a document equals the result of nlohmann's own parser") {
  for (const std::string rest :
       {R"("a": null, "b": [true, false, [], {}, [[1], {"c": {}}]])",
        R"("a": -1, "b": 18446744073709551615, "c": 0.1, "d": 1e300, "e": 18446744073709551616)",
        R"("a": "\u00e9\ud83c\udf3f\n", "": "the empty name", "b": {"a": {"a": []}})",
        R"("a": {"b": [1, 2, {"c": 3}]}, "a": [4], "a": {"b": "the last counts"})"}) {
    const std::string text = R"({"asset": {"version": "2.0"}, )" + rest + "}";
    const auto opened = openGltf(std::as_bytes(std::span(text)));
    REQUIRE(std::holds_alternative<GltfContainer>(opened));
    CHECK(std::get<GltfContainer>(opened).document == nlohmann::json::parse(text));
  }
  const std::string fault = R"({"asset": {"version": "2.0"}, "a" 1})";
  CHECK(checkBundle(std::as_bytes(std::span(fault))).front().message ==
        "JSON syntax error at byte 35");
}

TEST_CASE("base64 has the test vectors of RFC 4648, section 10") {
  const std::string kStart = "data:;base64,";
  const std::string_view text = "foobar";
  for (std::size_t length = 0;
       const char* coded : {"", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy"}) {
    const auto bytes = std::as_bytes(std::span(text.substr(0, length++)));
    CHECK(encodeBase64(bytes) == coded);
    const auto decoded = readDataUri(kStart + coded);
    REQUIRE(decoded.ok());
    CHECK(std::equal(decoded.value().begin(), decoded.value().end(), bytes.begin(), bytes.end()));
  }
  CHECK(encodeBase64(std::array{std::byte(0xfb), std::byte(0xff)}) == "+/8=");
  std::vector<std::byte> all(256);
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = std::byte(i);
  CHECK(readDataUri(kStart + encodeBase64(all)).value() == all);
  CHECK(readDataUri(kStart + "Zm8").value() == readDataUri(kStart + "Zm8=").value());
  for (const char* wrong : {"Z", "Zm9v=Zm9", "Zm 9", "Zm9-", "====", "Zm9vZ==="})
    CHECK_FALSE(readDataUri(kStart + wrong).ok());
}

TEST_CASE("every truncated length of a GLB is refused") {
  const std::vector<std::byte> file = smallFile();
  REQUIRE(parseBundle(file, "x").ok());
  for (std::size_t length = 0; length < file.size(); ++length)
    REQUIRE_FALSE(parseBundle(std::span(file).first(length), "x").ok());
}

TEST_CASE("every truncated length of a .gltf with its buffer inside is refused") {
  GlbParts parts(smallFile());
  parts.json["buffers"][0] = {
      {"byteLength", parts.binary.size()},
      {"uri", "data:application/gltf-buffer;base64," + encodeBase64(parts.binary)}};
  const std::string text = parts.json.dump();
  REQUIRE(parseBundle(std::as_bytes(std::span(text)), "x").ok());
  for (std::size_t length = 0; length < text.size(); ++length)
    REQUIRE_FALSE(parseBundle(std::as_bytes(std::span(text)).first(length), "x").ok());
}

TEST_CASE("every truncated length of a KTX2 file is refused") {
  const std::vector<std::byte> file =
      encodeKtx2(example::patternTable("", TexelFormat::rg16Sfloat, 8, 4, 0, 4));
  for (std::size_t length = 0; length < file.size(); ++length)
    REQUIRE_FALSE(decodeKtx2(std::span(file).first(length), "x").ok());
}

TEST_CASE("each mip level of a KTX2 file starts at a multiple of its texels' size and of four") {
  for (const TexelFormat format :
       {TexelFormat::r8Unorm, TexelFormat::rg8Unorm, TexelFormat::rgba8Unorm,
        TexelFormat::rg16Sfloat, TexelFormat::rgba16Sfloat, TexelFormat::rgba32Sfloat})
    for (const std::uint32_t levels : {1u, 2u, 3u}) {
      const std::vector<std::byte> file =
          encodeKtx2(example::patternTable("", format, 5, 3, 0, levels));
      for (std::size_t level = 0; level < levels; ++level) {
        constexpr std::size_t kLevelIndex = 80; // KTX 2.0, section 3.1
        std::uint64_t offset = 0;
        std::memcpy(&offset, file.data() + kLevelIndex + 24 * level, sizeof offset);
        CHECK(offset % std::lcm(texelBytes(format), std::size_t(4)) == 0);
      }
    }
}

TEST_CASE("every fault of the GLB framing is found") {
  const auto withWord = [](std::size_t offset, std::uint32_t value) {
    std::vector<std::byte> file = smallFile();
    std::memcpy(file.data() + offset, &value, sizeof value);
    return file;
  };
  CHECK(codeOf(withWord(0, 0x46546C68u)) == "not-gltf");
  CHECK(codeOf(withWord(4, 1)) == "glb-version");
  CHECK(codeOf(withWord(8, 100)) == "glb-length");
  CHECK(codeOf(withWord(12, 0xfffffffcu)) == "glb-chunk");
  CHECK(codeOf(withWord(12, 7)) == "glb-chunk");
  CHECK(codeOf(withWord(16, 0x004E4942u)) == "glb-chunk");
  std::vector<std::byte> longer = smallFile();
  longer.resize(longer.size() + 4);
  CHECK(codeOf(longer) == "glb-length");
  std::vector<std::byte> headerOnly = smallFile();
  headerOnly.resize(12);
  const std::uint32_t length = 12;
  std::memcpy(headerOnly.data() + 8, &length, sizeof length);
  CHECK(codeOf(headerOnly) == "glb-chunk");
}

TEST_CASE("the error for a file of another kind names the kind") {
  for (const auto& [start, kind] : {std::pair("\x89PNG\r\n\x1a\n", "is a PNG image"),
                                    {"\xff\xd8\xff\xe0", "is a JPEG image"},
                                    {"v/1\x01", "is an EXR image"},
                                    {"\xabKTX 20\xbb", "is a KTX texture"},
                                    {"BLENDER-v", "is a Blender file"},
                                    {"Kaydara FBX Binary", "is an FBX file"},
                                    {"# an OBJ file", "is neither a GLB (first bytes glTF) nor a "
                                                      "JSON object"}}) {
    const auto bytes = std::as_bytes(std::span(start, std::strlen(start)));
    CHECK(parseBundle(bytes, "x").error().message ==
          std::string("x: ") + kind + "; expected a .glb or .gltf");
  }
}

TEST_CASE("a file that is not glTF, nested too deeply, too large or not JSON is an error") {
  CHECK(codeOfText("") == "not-gltf");
  CHECK(codeOfText("a photograph") == "not-gltf");
  CHECK(codeOfText("[]") == "not-gltf");
  CHECK(codeOfText("{\"asset\":") == "json-syntax");
  CHECK(codeOfText("{\"asset\": {\"version\": \"2.0\"}, \"n\": 1e999}") == "json-syntax");
  CHECK(codeOfText("{\"a\": \"\xff\"}") == "json-syntax");
  CHECK(codeOfText("{\"asset\": {\"version\": 2}}") == "asset-version");
  CHECK(codeOfText("{\"a\":" + std::string(1000000, '[')) == "json-depth");
  CHECK(codeOfText("{\"a\":" + std::string(65, '[') + std::string(65, ']') + "}") == "json-depth");
  std::string large = "{\"a\": \"";
  large.resize((std::size_t(64) << 20u) + 1, 'a');
  CHECK(codeOfText(large + "\"}") == "json-size");
}

TEST_CASE("JSON may have up to four million values") {
  const auto holding = [](std::size_t values) {
    constexpr std::size_t kOthers = 4; // the root, asset, version and the array
    std::string text = R"({"asset": {"version": "2.0"}, "extras": [0)";
    for (std::size_t k = kOthers + 1; k < values; ++k)
      text += ",0";
    return text + "]}";
  };
  constexpr std::size_t kMost = std::size_t(4) << 20u;
  const std::string most = holding(kMost);
  CHECK(std::holds_alternative<GltfContainer>(openGltf(std::as_bytes(std::span(most)))));
  CHECK(codeOfText(holding(kMost + 1)) == "json-count");
}

TEST_CASE("brackets inside strings do not count as nesting") {
  GlbParts parts(smallFile());
  parts.extension()["noises"][0]["name"] = std::string(1000, '[') + "\\\"" + std::string(99, '{');
  CHECK(parseBundle(parts.join(), "x").ok());
}

TEST_CASE("a chunk of an unknown type after the binary one is ignored") {
  std::vector<std::byte> file = smallFile();
  GlbParts::append(file, 4);
  GlbParts::append(file, 0x12345678u);
  GlbParts::append(file, 0);
  const auto length = std::uint32_t(file.size());
  std::memcpy(file.data() + 8, &length, sizeof length);
  CHECK(parseBundle(file, "x").ok());
}

TEST_CASE("buffers in data URIs are read, of any length modulo three") {
  for (std::size_t extra = 0; extra < 3; ++extra) {
    GlbParts parts(smallFile());
    parts.binary.resize(parts.binary.size() + extra);
    parts.json["buffers"][0] = {
        {"byteLength", parts.binary.size()},
        {"uri", "data:application/octet-stream;base64," + encodeBase64(parts.binary)}};
    const std::string text = parts.json.dump();
    const auto bundle = parseBundle(std::as_bytes(std::span(text)), "x");
    REQUIRE(bundle.ok());
    CHECK(bundle.value().tables[0].texels == example::smallest().bundle.tables[0].texels);
  }
}

TEST_CASE("the function of the caller supplies the files that a .gltf in memory names") {
  GlbParts parts(smallFile());
  parts.json["buffers"][0] = {{"byteLength", parts.binary.size()}, {"uri", "my%20own.bin"}};
  const std::string text = parts.json.dump();
  const auto readWith = [&](const ExternalFile& externalFile) {
    const auto bundle = parseBundle(std::as_bytes(std::span(text)), "x", externalFile);
    return bundle ? "" : bundle.error().message;
  };
  CHECK(readWith([&](const std::string& uri, std::size_t length) {
          CHECK(uri == "my%20own.bin");
          CHECK(pathOfUri(uri) == "my own.bin");
          CHECK(length == parts.binary.size());
          std::vector<std::byte> more = parts.binary;
          more.resize(length + 1);
          return Result(more);
        }).empty());
  const std::string place = "x: /buffers/0/";
  CHECK(readWith([](const std::string&, std::size_t) -> Result<std::vector<std::byte>> {
          return Error{ErrorKind::badInput, "my own.bin is locked"};
        }) == place + "uri: my own.bin is locked");
  CHECK(
      readWith([](const std::string&, std::size_t) { return Result(std::vector<std::byte>(3)); }) ==
      place + "byteLength: " + std::to_string(parts.binary.size()) + " bytes; available: 3");
  CHECK(readWith({}) == place + "uri: URI \"my%20own.bin\" points outside the file's folder");
}

TEST_CASE("a buffer file outside the folder of the .gltf is never read") {
  const TemporaryFolder folder;
  const std::filesystem::path inside = folder.path() / "inside";
  std::filesystem::create_directory(inside);
  GlbParts parts(smallFile());
  REQUIRE(replaceFile(folder.path() / "secret.bin", parts.binary).ok());
  REQUIRE(replaceFile(inside / "own.bin", parts.binary).ok());
  std::filesystem::create_symlink(folder.path() / "secret.bin", inside / "link.bin");
  std::filesystem::create_directory_symlink(folder.path(), inside / "up");
  const auto readWith = [&](const std::string& uri) {
    parts.json["buffers"][0] = {{"byteLength", parts.binary.size()}, {"uri", uri}};
    writeText(inside / "scene.gltf", parts.json.dump());
    return readBundle(inside / "scene.gltf");
  };
  CHECK(readWith("own.bin").ok());
  CHECK(readWith("./own%2Ebin").ok());
  for (const std::string& uri :
       {std::string("../secret.bin"), std::string("%2e%2e/secret.bin"), std::string("link.bin"),
        std::string("up/secret.bin"), (folder.path() / "secret.bin").string(),
        "file://" + (folder.path() / "secret.bin").string(), std::string("own.bin%00"),
        std::string("own.bi%6"), std::string(""), std::string("."), std::string("absent.bin")}) {
    INFO(uri);
    const auto bundle = readWith(uri);
    REQUIRE_FALSE(bundle.ok());
    CHECK(bundle.error().kind == ErrorKind::badInput);
  }
}

TEST_CASE("only the claimed bytes are read of a big file that thousands of buffers name") {
  const TemporaryFolder folder;
  constexpr std::uintmax_t kHuge = std::uintmax_t(1) << 40; // sparse: uses no disk space
  GlbParts parts(smallFile());
  REQUIRE(replaceFile(folder / "big.bin", parts.binary).ok());
  std::filesystem::resize_file(folder / "big.bin", kHuge);
  const std::size_t views = parts.json["bufferViews"].size();
  for (std::size_t v = 0; v < views; ++v)
    parts.json["bufferViews"][v]["buffer"] = v;
  parts.json["buffers"] = nlohmann::json::array();
  for (int b = 0; b < 4096; ++b)
    parts.json["buffers"].push_back({{"byteLength", parts.binary.size()}, {"uri", "big.bin"}});
  writeText(folder / "scene.gltf", parts.json.dump());
  CHECK(readBundle(folder / "scene.gltf").ok());

  // A declared length of the whole file, or above the limit for all buffers together.
  for (const std::uintmax_t length : {kHuge, (std::uintmax_t(4) << 30) + 1}) {
    parts.json["buffers"][0]["byteLength"] = length;
    writeText(folder / "scene.gltf", parts.json.dump());
    const auto bundle = readBundle(folder / "scene.gltf");
    REQUIRE_FALSE(bundle.ok());
    CHECK(bundle.error().kind == ErrorKind::badInput);
    CHECK_THAT(bundle.error().message, Catch::Contains("at most 4294967296 in all buffers"));
  }
}

TEST_CASE("a buffer's file that is shorter than it claims is refused") {
  const TemporaryFolder folder;
  GlbParts parts(smallFile());
  REQUIRE(replaceFile(folder / "own.bin", parts.binary).ok());
  parts.json["buffers"][0] = {{"byteLength", parts.binary.size() + 1}, {"uri", "own.bin"}};
  writeText(folder / "scene.gltf", parts.json.dump());
  const auto bundle = readBundle(folder / "scene.gltf");
  REQUIRE_FALSE(bundle.ok());
  CHECK(bundle.error().kind == ErrorKind::badInput);
  CHECK_THAT(bundle.error().message, Catch::Contains("own.bin"));
}

TEST_CASE("the error for a missing file or a folder names it") {
  const TemporaryFolder folder;
  for (const std::filesystem::path& path : {folder.path() / "absent.glb", folder.path()}) {
    const auto bundle = readBundle(path);
    REQUIRE_FALSE(bundle.ok());
    CHECK(bundle.error().kind == ErrorKind::badInput);
    CHECK(bundle.error().message.rfind(path.string(), 0) == 0);
    CHECK_FALSE(checkBundle(path).ok());
  }
}
