// SPDX-License-Identifier: MIT
// File -> JSON document and binary chunk; see gltf_file.h.
#include "gltf_file.h"

#include <lichen/files.h>

namespace lichen::renderer {
namespace {

// tinygltf takes the size as a 32-bit integer.
constexpr std::size_t kMaxGltfBytes = (std::size_t(1) << 32) - 1;

} // namespace

Result<GltfFile> readGltfFile(const std::filesystem::path& path) {
  Result<std::vector<std::byte>> bytes = readFile(path, kMaxGltfBytes);
  if (!bytes)
    return bytes.error();
  return openGltfFile(std::move(bytes).value(), path);
}

Result<GltfFile> openGltfFile(std::vector<std::byte> bytes, const std::filesystem::path& path) {
  GltfFile file{path, std::move(bytes), {}};
  std::variant<GltfContainer, Finding> opened = openGltf(file.bytes);
  if (const auto* fault = std::get_if<Finding>(&opened))
    return Error{fault->code == "memory" ? ErrorKind::resources : ErrorKind::badInput,
                 path.string() + ": " + fault->pointer + (fault->pointer.empty() ? "" : ": ") +
                     fault->message};
  file.container = std::get<GltfContainer>(std::move(opened));
  return file;
}

} // namespace lichen::renderer
