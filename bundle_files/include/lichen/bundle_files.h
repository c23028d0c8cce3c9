// SPDX-License-Identifier: MIT
// Reads and checks bundles in files.
#pragma once

#include <lichen/bundle.h>

#include <filesystem>

namespace lichen {

/// As parseBundle(), from a .glb or .gltf file. Buffers may also be in files inside the .gltf's
/// folder; the reader never follows a path out of that folder. Messages begin with `path`.
/// Thread-safe.
[[nodiscard]] Result<Bundle> readBundle(const std::filesystem::path& path);

/// As checkBundle() of bytes, from a file. Returns an Error only if the file cannot be read, or is
/// not a complete GLB or glTF 2 JSON. Thread-safe.
[[nodiscard]] Result<std::vector<Finding>> checkBundle(const std::filesystem::path& path);

/// Returns the size of a file and, for a .gltf, of the buffers in separate files that exist.
/// Errors: as of readFile(). Throws std::bad_alloc.
[[nodiscard]] Result<std::size_t> bytesOnDisk(const std::filesystem::path& path);

} // namespace lichen
