// SPDX-License-Identifier: MIT
// Public entry points for reading and checking. Both run the same pass over the file.
#include "extension_reader.h"

#include <lichen/files.h>

#include <algorithm>
#include <new>

namespace lichen {
namespace {

/// Reads the readable parts and records every fault. Returns nothing if the file is no complete
/// glTF.
std::optional<Bundle> inspect(std::span<const std::byte> file, const std::filesystem::path& folder,
                              FindingList& findings) {
  std::optional<GltfFile> gltf = GltfFile::open(file, folder, findings);
  if (!gltf)
    return std::nullopt;
  GltfTables tables(*gltf);
  return readExtension(gltf->document(), tables, findings);
}

/// The message for when even a finding does not fit into memory. `name` is a path or a string.
auto unread(const auto& name) {
  return
      [&name] { return std::filesystem::path(name).string() + ": not enough memory to read it"; };
}

Result<Bundle> read(std::span<const std::byte> file, const std::filesystem::path& folder,
                    const std::string& name) {
  FindingList findings;
  std::optional<Bundle> bundle = inspect(file, folder, findings);
  if (const Finding* fault = findings.firstError())
    return asError(*fault, name);
  return std::move(*bundle);
}

} // namespace

Error asError(const Finding& finding, const std::string& title) {
  return {finding.code == "memory" ? ErrorKind::resources : ErrorKind::badInput,
          title + ": " + finding.pointer + (finding.pointer.empty() ? "" : ": ") + finding.message};
}

Result<Bundle> readBundle(const std::filesystem::path& path) {
  return withinMemory(unread(path), [&]() -> Result<Bundle> {
    const Result<std::vector<std::byte>> file = readFile(path);
    return file ? read(file.value(), folderOf(path), path.string()) : file.error();
  });
}

Result<Bundle> parseBundle(std::span<const std::byte> file, const std::string& name) {
  return withinMemory(unread(name), [&] { return read(file, {}, name); });
}

Result<std::vector<Finding>> checkBundle(const std::filesystem::path& path) {
  return withinMemory(unread(path), [&]() -> Result<std::vector<Finding>> {
    const Result<std::vector<std::byte>> file = readFile(path);
    if (!file)
      return file.error();
    FindingList findings;
    if (!inspect(file.value(), folderOf(path), findings))
      return asError(*findings.firstError(), path.string());
    for (const Finding& finding : findings.all())
      if (finding.code == "memory") // a part that did not fit may be valid
        return asError(finding, path.string());
    return findings.all();
  });
}

std::vector<Finding> checkBundle(std::span<const std::byte> file) {
  try {
    FindingList findings;
    static_cast<void>(inspect(file, {}, findings));
    return findings.all();
  } catch (const std::bad_alloc&) {
    return {{Finding::Severity::error, "memory", "", "not enough memory to read it"}};
  }
}

} // namespace lichen
