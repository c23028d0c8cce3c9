// SPDX-License-Identifier: MIT
// A glTF file in memory, split into its container parts.
#pragma once

#include <lichen/gltf_container.h>

#include <cstddef>
#include <filesystem>
#include <vector>

namespace lichen::renderer {

struct GltfFile {
  std::filesystem::path path;
  std::vector<std::byte> bytes; ///< the whole file
  GltfContainer container;      ///< refers into `bytes`
};

/// Errors: badInput if the file cannot be read or is not glTF; resources if memory does not
/// suffice.
[[nodiscard]] Result<GltfFile> readGltfFile(const std::filesystem::path& path);
/// Like readGltfFile(), but from bytes in memory. `path` names the file in messages and locates the
/// files it refers to.
[[nodiscard]] Result<GltfFile> openGltfFile(std::vector<std::byte> bytes,
                                            const std::filesystem::path& path);

} // namespace lichen::renderer
