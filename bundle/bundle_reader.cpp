// SPDX-License-Identifier: MIT
// Public entry points for reading and checking. Both run the same pass over the file.
#include "extension_reader.h"

#include <new>

namespace lichen {

Error asError(const Finding& finding, const std::string& title) {
  return {finding.code == "memory" ? ErrorKind::resources : ErrorKind::badInput,
          title + ": " + finding.pointer + (finding.pointer.empty() ? "" : ": ") + finding.message};
}

std::optional<Bundle> inspectBundle(std::span<const std::byte> file, ExternalFile externalFile,
                                    FindingList& findings) {
  std::optional<GltfFile> gltf = GltfFile::open(file, std::move(externalFile), findings);
  if (!gltf)
    return std::nullopt;
  GltfTables tables(*gltf);
  return readExtension(gltf->document(), tables, findings);
}

Result<Bundle> parseBundle(std::span<const std::byte> file, const std::string& name,
                           const ExternalFile& externalFile) {
  return withinMemory([&] { return name + ": not enough memory to read it"; },
                      [&]() -> Result<Bundle> {
                        FindingList findings;
                        std::optional<Bundle> bundle = inspectBundle(file, externalFile, findings);
                        if (const Finding* fault = findings.firstError())
                          return asError(*fault, name);
                        return std::move(*bundle);
                      });
}

std::vector<Finding> checkBundle(std::span<const std::byte> file,
                                 const ExternalFile& externalFile) {
  try {
    FindingList findings;
    static_cast<void>(inspectBundle(file, externalFile, findings));
    return findings.all();
  } catch (const std::bad_alloc&) {
    return {{Finding::Severity::error, "memory", "", "not enough memory to read it"}};
  }
}

} // namespace lichen
