// SPDX-License-Identifier: MIT
// Reads files and passes their bytes to the reader; see bundle_files.h.
#include "extension_reader.h"

#include <lichen/bundle_files.h>
#include <lichen/files.h>
#include <lichen/gltf_files.h>

namespace lichen {
namespace {

/// The message for when even a finding does not fit into memory.
auto unread(const std::filesystem::path& path) {
  return [&path] { return path.string() + ": not enough memory to read it"; };
}

} // namespace

Result<Bundle> readBundle(const std::filesystem::path& path) {
  return withinMemory(unread(path), [&]() -> Result<Bundle> {
    const Result<std::vector<std::byte>> file = readFile(path);
    if (!file)
      return file.error();
    return parseBundle(file.value(), path.string(), filesBeside(path));
  });
}

Result<std::vector<Finding>> checkBundle(const std::filesystem::path& path) {
  return withinMemory(unread(path), [&]() -> Result<std::vector<Finding>> {
    const Result<std::vector<std::byte>> file = readFile(path);
    if (!file)
      return file.error();
    FindingList findings;
    if (!inspectBundle(file.value(), filesBeside(path), findings))
      return asError(*findings.firstError(), path.string());
    for (const Finding& finding : findings.all())
      if (finding.code == "memory") // a part that did not fit may be valid
        return asError(finding, path.string());
    return findings.all();
  });
}

Result<std::size_t> bytesOnDisk(const std::filesystem::path& path) {
  const Result<std::vector<std::byte>> file = readFile(path);
  if (!file)
    return file.error();
  std::size_t sum = file.value().size();
  const std::variant<GltfContainer, Finding> opened = openGltf(file.value());
  const auto* container = std::get_if<GltfContainer>(&opened);
  if (container == nullptr || !container->document.contains("buffers"))
    return sum;
  for (const nlohmann::json& buffer : container->document["buffers"]) {
    // Reading the bundle did not validate buffers without tables.
    const std::string* uri = stringMember(buffer, "uri");
    if (uri == nullptr)
      continue;
    std::error_code absent;
    const Result<std::filesystem::path> beside = fileOfUri(path, *uri);
    const std::uintmax_t bytes = beside ? std::filesystem::file_size(beside.value(), absent) : 0;
    if (!absent)
      sum += std::size_t(bytes);
  }
  return sum;
}

} // namespace lichen
