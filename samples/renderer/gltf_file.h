// SPDX-License-Identifier: MIT
// A glTF file in memory with its frame taken off.
#pragma once

#include <lichen/gltf_container.h>

#include <cstddef>
#include <filesystem>
#include <vector>

namespace lichen::renderer {

struct GltfFile {
  std::filesystem::path path;
  std::vector<std::byte> bytes; ///< the whole file
  GltfContainer container;      ///< borrows from `bytes`
};

/// Errors: badInput for a file that cannot be read or is no glTF, resources when memory does not
/// suffice.
[[nodiscard]] Result<GltfFile> readGltfFile(const std::filesystem::path& path);
/// As above of bytes in memory, which stand for the file at `path`.
[[nodiscard]] Result<GltfFile> openGltfFile(std::vector<std::byte> bytes,
                                            const std::filesystem::path& path);

} // namespace lichen::renderer
