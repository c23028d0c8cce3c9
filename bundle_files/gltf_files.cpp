// SPDX-License-Identifier: MIT
// Frames a GLB, and finds external files; see gltf_files.h.
#include "data_uri.h"
#include "gltf_file.h"

#include <lichen/files.h>
#include <lichen/gltf_files.h>

#include <algorithm>

namespace lichen {
namespace {

void appendWord(std::vector<std::byte>& bytes, std::size_t value) {
  const auto narrow = std::uint32_t(value);
  const auto view = std::as_bytes(std::span(&narrow, 1));
  bytes.insert(bytes.end(), view.begin(), view.end());
}

/// Resolves a relative path inside `folder`. Returns nothing if the path leaves the folder.
std::optional<std::filesystem::path> fileInside(const std::filesystem::path& folder,
                                                const std::filesystem::path& relative) {
  if (relative.empty() || relative.has_root_path())
    return std::nullopt;
  std::error_code error;
  const auto root = std::filesystem::weakly_canonical(folder, error);
  if (error)
    return std::nullopt;
  const auto target = std::filesystem::weakly_canonical(root / relative, error);
  if (error)
    return std::nullopt;
  const auto [rootEnd, targetEnd] =
      std::mismatch(root.begin(), root.end(), target.begin(), target.end());
  if (rootEnd != root.end() || targetEnd == target.end())
    return std::nullopt;
  return target;
}

} // namespace

std::vector<std::byte> frameGlb(std::string text, std::span<const std::byte> binary,
                                std::span<const std::byte> otherChunks) {
  const auto padded = [](std::size_t size) {
    return (size + kGlbAlignment - 1) / kGlbAlignment * kGlbAlignment;
  };
  text.resize(padded(text.size()), ' ');
  const std::size_t binarySize = padded(binary.size());
  const std::size_t binaryChunkSize = binary.empty() ? 0 : kGlbChunkHeaderBytes + binarySize;
  std::vector<std::byte> glb;
  appendWord(glb, kGlbMagic);
  appendWord(glb, kGlbVersion);
  appendWord(glb, kGlbHeaderBytes + kGlbChunkHeaderBytes + text.size() + binaryChunkSize +
                      otherChunks.size());
  appendWord(glb, text.size());
  appendWord(glb, kGlbChunkJson);
  const auto textBytes = std::as_bytes(std::span(text));
  glb.insert(glb.end(), textBytes.begin(), textBytes.end());
  if (!binary.empty()) {
    appendWord(glb, binarySize);
    appendWord(glb, kGlbChunkBin);
    glb.insert(glb.end(), binary.begin(), binary.end());
    glb.resize(glb.size() + binarySize - binary.size());
  }
  glb.insert(glb.end(), otherChunks.begin(), otherChunks.end());
  return glb;
}

std::filesystem::path folderOf(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : ".";
}

Result<std::filesystem::path> fileOfUri(const std::filesystem::path& asset,
                                        const std::string& uri) {
  const auto relative = pathOfUri(uri);
  const auto path = relative ? fileInside(folderOf(asset), *relative) : std::nullopt;
  if (!path)
    return unresolvedUri(uri);
  return *path;
}

Result<std::vector<std::byte>> readUri(const std::filesystem::path& asset, const std::string& uri,
                                       std::optional<std::size_t> length) {
  if (isDataUri(uri))
    return readDataUri(uri);
  const Result<std::filesystem::path> path = fileOfUri(asset, uri);
  if (!path)
    return path.error();
  return length ? readFileStart(path.value(), *length) : readFile(path.value());
}

ExternalFile filesBeside(const std::filesystem::path& asset) {
  return
      [asset](const std::string& uri, std::size_t length) { return readUri(asset, uri, length); };
}

} // namespace lichen
