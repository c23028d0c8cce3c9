// SPDX-License-Identifier: MIT
// Writes a .gltf and the binary beside it, replacing earlier files atomically as a pair.
#pragma once

#include <lichen/result.h>

#include <filesystem>
#include <span>
#include <string>

namespace lichen {

/// Whether a path names a .glb, and not a .gltf. Errors: usage for another extension.
[[nodiscard]] Result<bool> isGlbPath(const std::filesystem::path& path);

/// The relative URI of the binary of `path`: STEM.HASH.bin, where HASH depends on the content. An
/// old .gltf therefore keeps its own binary until the new .gltf is complete.
[[nodiscard]] std::string binaryUri(const std::filesystem::path& path,
                                    std::span<const std::byte> binary);

/// Writes `binary`, unless it is empty, to the file of binaryUri(), then `text` to `path`. Then
/// removes binaries with such names to which the previous .gltf referred and `text` does not.
/// Errors: as of replaceFile(), which leave the old files intact and no new ones. Throws
/// std::bad_alloc.
[[nodiscard]] Result<void> writeGltfPair(const std::filesystem::path& path, const std::string& text,
                                         std::span<const std::byte> binary);

} // namespace lichen
