// SPDX-License-Identifier: MIT
// A .gltf and the binary beside it, which replace others as one.
#pragma once

#include <lichen/result.h>

#include <filesystem>
#include <span>
#include <string>

namespace lichen {

/// The relative URI of the binary of `path`: STEM.HASH.bin, named by its content, so that an old
/// .gltf keeps its own until the new one is whole.
[[nodiscard]] std::string binaryUri(const std::filesystem::path& path,
                                    std::span<const std::byte> binary);

/// Writes `binary`, unless it is empty, under its name, then `text` at `path`. Binaries of such
/// names that the .gltf which was there refers to, and `text` does not, are removed. Errors as
/// replaceFile, with the old files whole and no other. Throws std::bad_alloc.
[[nodiscard]] Result<void> writeGltfPair(const std::filesystem::path& path, const std::string& text,
                                         std::span<const std::byte> binary);

} // namespace lichen
