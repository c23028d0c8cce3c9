// SPDX-License-Identifier: MIT
// Frame of .gltf and .glb [glTF 2.0, section 4.4].
#include "gltf_file.h"

#include <lichen/files.h>

#include <algorithm>
#include <cstring>
#include <new>
#include <string_view>

namespace lichen::renderer {
namespace {

constexpr std::uint32_t kGlbMagic = 0x46546C67u;  // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534Au; // "JSON"
constexpr std::uint32_t kBinChunk = 0x004E4942u;  // "BIN\0"
constexpr std::size_t kGlbHeaderSize = 12;
constexpr std::size_t kChunkHeaderSize = 8;
// tinygltf counts bytes in 32 bits.
constexpr std::size_t kMaxGltfBytes = (std::size_t(1) << 32) - 1;
constexpr std::size_t kMaxParserMessage = 160;

std::uint32_t wordAt(const std::vector<std::byte>& bytes, std::size_t offset) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + offset, sizeof word);
  return word;
}

Error glbError(const std::filesystem::path& path, const std::string& what) {
  return Error{ErrorKind::badInput, path.string() + ": " + what};
}

/// The JSON text of a GLB; sets file.binaryChunkSize.
Result<std::string_view> jsonChunk(GltfFile& file) {
  const auto& bytes = file.bytes;
  if (bytes.size() < kGlbHeaderSize + kChunkHeaderSize)
    return glbError(file.path, "truncated GLB of " + std::to_string(bytes.size()) +
                                   " bytes; the headers alone take 20");
  if (const std::uint32_t version = wordAt(bytes, 4); version != 2)
    return glbError(file.path, "GLB version " + std::to_string(version) + "; 2 is accepted");
  if (const std::uint32_t length = wordAt(bytes, 8); length != bytes.size())
    return glbError(file.path, "GLB header claims " + std::to_string(length) +
                                   " bytes, the file has " + std::to_string(bytes.size()));
  const std::size_t jsonSize = wordAt(bytes, kGlbHeaderSize);
  if (wordAt(bytes, kGlbHeaderSize + 4) != kJsonChunk)
    return glbError(file.path, "the first GLB chunk is not JSON");
  const std::size_t jsonBegin = kGlbHeaderSize + kChunkHeaderSize;
  if (jsonSize > bytes.size() - jsonBegin || jsonSize % 4 != 0)
    return glbError(file.path, "JSON chunk of " + std::to_string(jsonSize) +
                                   " bytes; a multiple of 4 that fits the file is accepted");
  std::size_t next = jsonBegin + jsonSize;
  if (next < bytes.size()) {
    if (bytes.size() - next < kChunkHeaderSize)
      return glbError(file.path, "truncated GLB chunk header");
    const std::size_t size = wordAt(bytes, next);
    if (size > bytes.size() - next - kChunkHeaderSize)
      return glbError(file.path, "GLB chunk of " + std::to_string(size) +
                                     " bytes reaches beyond the end of the file");
    if (wordAt(bytes, next + 4) == kBinChunk)
      file.binaryChunkSize = size;
  }
  return std::string_view(reinterpret_cast<const char*>(bytes.data()) + jsonBegin, jsonSize);
}

/// Deepest nesting of objects and arrays in a JSON text, valid or not.
int nestingDepth(std::string_view text) {
  int depth = 0;
  int deepest = 0;
  bool inString = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (inString) {
      if (c == '\\')
        ++i;
      else if (c == '"')
        inString = false;
    } else if (c == '"') {
      inString = true;
    } else if (c == '{' || c == '[') {
      deepest = std::max(deepest, ++depth);
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
  return deepest;
}

} // namespace

std::string printable(const std::string& text, std::size_t maxLength) {
  std::string line = text.substr(0, maxLength);
  for (char& c : line)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      c = '?';
  return text.size() > maxLength ? line + "..." : line;
}

std::optional<std::filesystem::path> fileOfUri(const std::filesystem::path& gltfPath,
                                               const std::string& decodedUri) {
  if (decodedUri.empty() || decodedUri.find(':') != std::string::npos ||
      decodedUri.find('\\') != std::string::npos || decodedUri.find('\0') != std::string::npos)
    return std::nullopt;
  const std::filesystem::path relative(decodedUri);
  if (relative.is_absolute())
    return std::nullopt;
  for (const std::filesystem::path& part : relative)
    if (part == "..")
      return std::nullopt;
  return gltfPath.parent_path() / relative;
}

Result<GltfFile> readGltfFile(const std::filesystem::path& path) {
  Result<std::vector<std::byte>> bytes = readFile(path, kMaxGltfBytes);
  if (!bytes)
    return bytes.error();
  GltfFile file;
  file.path = path;
  file.bytes = std::move(bytes).value();
  std::string_view text(reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size());
  file.binary = file.bytes.size() >= 4 && wordAt(file.bytes, 0) == kGlbMagic;
  if (file.binary) {
    Result<std::string_view> chunk = jsonChunk(file);
    if (!chunk)
      return chunk.error();
    text = chunk.value();
  }
  if (const int depth = nestingDepth(text); depth > kMaxJsonDepth)
    return glbError(path, "JSON nested " + std::to_string(depth) + " levels deep; at most " +
                              std::to_string(kMaxJsonDepth) + " are accepted");
  try {
    file.json = nlohmann::json::parse(text.begin(), text.end());
  } catch (const std::bad_alloc&) {
    return Error{ErrorKind::resources, path.string() + ": not enough memory for its JSON"};
  } catch (const nlohmann::json::exception& fault) {
    return glbError(path,
                    std::string("not a glTF file: ") + printable(fault.what(), kMaxParserMessage));
  }
  if (!file.json.is_object())
    return glbError(path, "not a glTF file: its JSON is not an object");
  return file;
}

std::vector<std::byte> makeGlb(const nlohmann::json& json, std::span<const std::byte> binary) {
  std::string text = json.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::size_t binarySize = (binary.size() + 3) / 4 * 4;
  std::vector<std::byte> bytes;
  const auto word = [&](std::size_t value) {
    const auto narrow = std::uint32_t(value);
    const auto* begin = reinterpret_cast<const std::byte*>(&narrow);
    bytes.insert(bytes.end(), begin, begin + sizeof narrow);
  };
  word(kGlbMagic);
  word(2);
  word(kGlbHeaderSize + kChunkHeaderSize + text.size() +
       (binary.empty() ? 0 : kChunkHeaderSize + binarySize));
  word(text.size());
  word(kJsonChunk);
  const auto characters = std::as_bytes(std::span(text));
  bytes.insert(bytes.end(), characters.begin(), characters.end());
  if (!binary.empty()) {
    word(binarySize);
    word(kBinChunk);
    bytes.insert(bytes.end(), binary.begin(), binary.end());
    bytes.resize(bytes.size() + binarySize - binary.size());
  }
  return bytes;
}

} // namespace lichen::renderer
