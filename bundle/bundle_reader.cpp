// SPDX-License-Identifier: MIT
// Public entry points for reading and checking. Both run the same pass over the file.
#include "extension_reader.h"

#include <lichen/files.h>

#include <algorithm>
#include <new>

namespace lichen {
namespace {

/// Reads the readable parts and records every fault.
Bundle inspect(std::span<const std::byte> file, const std::filesystem::path& folder,
               FindingList& findings) {
  std::optional<GltfFile> gltf = GltfFile::open(file, folder, findings);
  return gltf ? readExtension(*gltf, findings) : Bundle{};
}

/// `name` is a path or a string.
Error notEnoughMemory(const auto& name) noexcept {
  return memoryError(
      [&] { return std::filesystem::path(name).string() + ": not enough memory to read it"; });
}

Result<Bundle> read(std::span<const std::byte> file, const std::filesystem::path& folder,
                    const std::string& name) {
  FindingList findings;
  Bundle bundle = inspect(file, folder, findings);
  if (findings.errorCount() == 0)
    return bundle;
  const auto first =
      std::find_if(findings.all().begin(), findings.all().end(), [](const Finding& finding) {
        return finding.severity == Finding::Severity::error;
      });
  if (first->code == "memory")
    return notEnoughMemory(name);
  return Error{ErrorKind::badInput, name + ": " + first->pointer +
                                        (first->pointer.empty() ? "" : ": ") + first->message};
}

} // namespace

Result<Bundle> readBundle(const std::filesystem::path& path) {
  try {
    const Result<std::vector<std::byte>> file = readFile(path);
    if (!file)
      return file.error();
    return read(file.value(), folderOf(path), path.string());
  } catch (const std::bad_alloc&) {
    return notEnoughMemory(path);
  }
}

Result<Bundle> parseBundle(std::span<const std::byte> file, const std::string& name) {
  try {
    return read(file, {}, name);
  } catch (const std::bad_alloc&) {
    return notEnoughMemory(name);
  }
}

Result<std::vector<Finding>> checkBundle(const std::filesystem::path& path) {
  try {
    const Result<std::vector<std::byte>> file = readFile(path);
    if (!file)
      return file.error();
    FindingList findings;
    std::optional<GltfFile> gltf = GltfFile::open(file.value(), folderOf(path), findings);
    if (gltf)
      static_cast<void>(readExtension(*gltf, findings));
    else if (const Finding& fault = findings.all().front(); fault.code != "memory")
      return Error{ErrorKind::badInput, path.string() + ": " + fault.pointer +
                                            (fault.pointer.empty() ? "" : ": ") + fault.message};
    // A part that did not fit in memory may be valid.
    if (std::any_of(findings.all().begin(), findings.all().end(),
                    [](const Finding& finding) { return finding.code == "memory"; }))
      return notEnoughMemory(path);
    return findings.all();
  } catch (const std::bad_alloc&) {
    return notEnoughMemory(path);
  }
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
