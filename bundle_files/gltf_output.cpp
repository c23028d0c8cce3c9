// SPDX-License-Identifier: MIT
// Writes a .gltf and its binary; see gltf_output.h.
#include "gltf_output.h"

#include "gltf_container.h"
#include "object_reader.h"

#include <lichen/files.h>

#include <algorithm>

namespace lichen {
namespace {

/// A file name as a relative URI, with all but unreserved characters (RFC 3986) as %XX.
std::string uriOf(const std::string& fileName) {
  constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string uri;
  for (const char c : fileName) {
    const bool unreserved = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                            (c >= '0' && c <= '9') ||
                            std::string_view("-._~").find(c) != std::string_view::npos;
    if (unreserved) {
      uri += c;
    } else {
      const auto code = static_cast<unsigned char>(c);
      uri += {'%', kHex[code >> 4u], kHex[code & 15u]};
    }
  }
  return uri;
}

constexpr std::size_t kHashDigits = 8;

/// 32-bit FNV-1a in hexadecimal (Fowler, Noll, Vo; draft-eastlake-fnv). It is long enough to
/// distinguish the few binaries of one stem.
std::string hashOf(std::span<const std::byte> bytes) {
  std::uint32_t hash = 0x811c9dc5u;
  for (const std::byte b : bytes)
    hash = (hash ^ std::to_integer<std::uint32_t>(b)) * 0x01000193u;
  std::string digits(kHashDigits, '0');
  for (std::size_t i = kHashDigits; i-- > 0; hash >>= 4u)
    digits[i] = "0123456789abcdef"[hash & 15u];
  return digits;
}

/// STEM.HASH.bin beside `path`.
std::filesystem::path binaryBeside(const std::filesystem::path& path, const std::string& hash) {
  return std::filesystem::path(path).replace_extension("." + hash + ".bin");
}

/// The hash in the name of a binary of `path`, or nothing for another name.
std::optional<std::string> hashIn(const std::string& uri, const std::filesystem::path& path) {
  const std::string before = uriOf(path.stem().string()) + ".";
  if (uri.size() < before.size() + kHashDigits)
    return std::nullopt;
  const std::string hash = uri.substr(before.size(), kHashDigits);
  if (uri != before + hash + ".bin" ||
      hash.find_first_not_of("0123456789abcdef") != std::string::npos)
    return std::nullopt;
  return hash;
}

/// The binaries named STEM.HASH.bin to which a .gltf at `path` refers.
std::vector<std::filesystem::path> binariesOf(std::span<const std::byte> gltf,
                                              const std::filesystem::path& path) {
  std::vector<std::filesystem::path> binaries;
  const std::variant<GltfContainer, Finding> opened = openGltf(gltf);
  const auto* container = std::get_if<GltfContainer>(&opened);
  if (container == nullptr)
    return binaries;
  const nlohmann::json* buffers = memberOf(&container->document, "buffers");
  if (buffers == nullptr || !buffers->is_array())
    return binaries;
  for (const nlohmann::json& buffer : *buffers)
    if (const std::string* uri = stringMember(buffer, "uri"))
      if (const auto hash = hashIn(*uri, path))
        binaries.push_back(binaryBeside(path, *hash));
  return binaries;
}

} // namespace

Result<bool> isGlbPath(const std::filesystem::path& path) {
  const std::filesystem::path extension = path.extension();
  if (extension != ".glb" && extension != ".gltf")
    return Error{ErrorKind::usage, path.string() + ": extension " + quoted(extension.string()) +
                                       "; expected .glb or .gltf"};
  return extension == ".glb";
}

std::string binaryUri(const std::filesystem::path& path, std::span<const std::byte> binary) {
  return uriOf(binaryBeside(path, hashOf(binary)).filename().string());
}

Result<void> writeGltfPair(const std::filesystem::path& path, const std::string& text,
                           std::span<const std::byte> binary) {
  const auto textBytes = std::as_bytes(std::span(text));
  std::vector<std::filesystem::path> superseded;
  if (const Result<std::vector<std::byte>> old = readFile(path); old)
    superseded = binariesOf(old.value(), path);
  const std::vector<std::filesystem::path> kept = binariesOf(textBytes, path);

  std::error_code ignored; // a binary that cannot be removed does not harm the asset
  const std::filesystem::path binaryPath = binaryBeside(path, hashOf(binary));
  const bool existed = std::filesystem::exists(binaryPath, ignored);
  if (!binary.empty())
    if (Result<void> written = replaceFile(binaryPath, binary); !written)
      return written;
  Result<void> written = replaceFile(path, textBytes);
  if (!written && !existed)
    std::filesystem::remove(binaryPath, ignored);
  if (written)
    for (const std::filesystem::path& old : superseded)
      if (std::find(kept.begin(), kept.end(), old) == kept.end())
        std::filesystem::remove(old, ignored);
  return written;
}

} // namespace lichen
