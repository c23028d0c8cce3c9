// SPDX-License-Identifier: MIT
// The container of .glb and .gltf; see gltf_container.h. Input is hostile: every length and nesting
// depth is checked before use.
#include "gltf_container.h"

#include "json_builder.h"
#include "object_reader.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <string_view>
#include <utility>

namespace lichen {
namespace {

using nlohmann::json;

/// Exporters stay below this limit unless they embed large buffers as data URIs.
constexpr std::size_t kMaxJsonBytes = std::size_t(64) << 20;
/// Limits the memory for the parsed document to 640 + 128 MiB. Measured on a 64-bit glibc heap, a
/// parsed value takes up to 160 bytes: 96 as an object's member, in a node of 80, and 64 as an
/// empty object of 48. In an array it takes at most 48 instead of 96, while the array doubles. The
/// characters of strings and names take up to twice the size of the text. Exporters write about 10
/// bytes of text per value.
constexpr std::size_t kMaxJsonValues = std::size_t(4) << 20;
/// glTF itself nests 8 levels deep; extensions and extras nest slightly deeper.
constexpr std::size_t kMaxJsonDepth = 64;

std::uint32_t word(std::span<const std::byte> bytes, std::size_t offset) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

/// Thrown to stop reading a container.
struct Fault {
  Finding finding;
};

[[noreturn]] void fail(const char* code, const std::string& message,
                       const std::string& pointer = "") {
  throw Fault{{Finding::Severity::error, code, pointer, message}};
}

/// Splits a GLB into its chunks.
void splitGlb(std::span<const std::byte> file, GltfContainer& container) {
  if (file.size() < kGlbHeaderBytes)
    fail("glb-length", "the GLB ends inside its header");
  if (const std::uint32_t version = word(file, 4); version != kGlbVersion)
    fail("glb-version", "GLB version " + std::to_string(version) + "; expected 2");
  if (const std::uint32_t length = word(file, 8); length != file.size())
    fail(
        "glb-length",
        (file.size() < length ? "the GLB is truncated: its header says " : "the GLB header says ") +
            std::to_string(length) + " bytes, the file has " + std::to_string(file.size()));
  std::size_t offset = kGlbHeaderBytes;
  for (int chunk = 0; offset < file.size(); ++chunk) {
    if (file.size() - offset < kGlbChunkHeaderBytes)
      fail("glb-chunk", "the GLB ends inside the header of chunk " + std::to_string(chunk));
    const std::uint32_t length = word(file, offset);
    const std::uint32_t type = word(file, offset + 4);
    offset += kGlbChunkHeaderBytes;
    if (length > file.size() - offset || length % kGlbAlignment != 0)
      fail("glb-chunk", "GLB chunk " + std::to_string(chunk) + " of " + std::to_string(length) +
                            " bytes; expected a multiple of 4, at most " +
                            std::to_string(file.size() - offset));
    if ((chunk == 0) != (type == kGlbChunkJson))
      fail("glb-chunk", "the first chunk of a GLB must be its only JSON");
    if (chunk == 0)
      container.text = file.subspan(offset, length);
    else if (chunk == 1 && type == kGlbChunkBin)
      container.binaryChunk = file.subspan(offset, length);
    else if (container.otherChunks.empty())
      container.otherChunks = file.subspan(offset - kGlbChunkHeaderBytes);
    offset += length;
  }
  if (offset == kGlbHeaderBytes)
    fail("glb-chunk", "the GLB has no JSON chunk");
}

/// Names the kind of a file that is not glTF, from its first bytes.
std::string kindOf(std::span<const std::byte> file) {
  constexpr std::pair<std::string_view, const char*> kKinds[] = {
      {"\x89PNG\r\n\x1a\n", "is a PNG image"}, {"\xff\xd8\xff", "is a JPEG image"},
      {"\x76\x2f\x31\x01", "is an EXR image"}, {"\xabKTX ", "is a KTX texture"},
      {"BLENDER", "is a Blender file"},        {"Kaydara FBX", "is an FBX file"},
  };
  const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
  for (const auto& [start, kind] : kKinds)
    if (text.starts_with(start))
      return kind;
  return "is neither a GLB (first bytes glTF) nor a JSON object";
}

void splitText(std::span<const std::byte> file, GltfContainer& container) {
  const auto first = std::find_if(file.begin(), file.end(), [](std::byte b) {
    return std::string_view(" \t\r\n").find(char(b)) == std::string_view::npos;
  });
  if (first == file.end() || char(*first) != '{')
    fail("not-gltf", kindOf(file) + "; expected a .glb or .gltf");
  container.text = file;
}

void parseJson(std::span<const std::byte> text, json& document) {
  if (text.size() > kMaxJsonBytes)
    fail("json-size", "JSON of " + std::to_string(text.size()) + " bytes; expected at most " +
                          std::to_string(kMaxJsonBytes));
  if (const std::optional<JsonFault> fault =
          buildJson(text, kMaxJsonValues, kMaxJsonDepth, document)) {
    if (fault->kind == JsonFault::Kind::depth)
      fail("json-depth",
           "JSON nested too deeply; expected at most " + std::to_string(kMaxJsonDepth) + " levels");
    if (fault->kind == JsonFault::Kind::count)
      fail("json-count",
           "too many JSON values; expected at most " + std::to_string(kMaxJsonValues));
    fail("json-syntax", fault->kind == JsonFault::Kind::range
                            ? "JSON with a number that is out of range"
                            : "JSON syntax error at byte " + std::to_string(fault->byte));
  }
  if (!document.is_object())
    fail("json-syntax", "the JSON document is not an object");
  const json* asset = memberOf(&document, "asset");
  const std::string* version = asset == nullptr ? nullptr : stringMember(*asset, "version");
  if (version == nullptr || !version->starts_with("2."))
    fail("asset-version", "absent or not 2.x; expected \"2.0\"", "/asset/version");
}

} // namespace

GltfContainer::~GltfContainer() { dismantle(document); }

std::variant<GltfContainer, Finding> openGltf(std::span<const std::byte> file) {
  try {
    GltfContainer container;
    container.isGlb = file.size() >= sizeof kGlbMagic && word(file, 0) == kGlbMagic;
    if (container.isGlb)
      splitGlb(file, container);
    else
      splitText(file, container);
    parseJson(container.text, container.document);
    return container;
  } catch (Fault& fault) {
    return std::move(fault.finding);
  } catch (const std::bad_alloc&) {
    return Finding{Finding::Severity::error, "memory", "", "not enough memory to read it"};
  }
}

} // namespace lichen
