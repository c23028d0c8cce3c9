// SPDX-License-Identifier: MIT
// The files of a glTF asset: a GLB's bytes, and the files that URIs name.
// Sources: glTF 2.0 specification, sections 4 (GLB) and 3.6.1 (URIs).
#pragma once

#include <lichen/bundle.h>

#include <filesystem>

namespace lichen {

/// Assembles a GLB from JSON text, a binary chunk, which may be empty, and complete further chunks.
/// The result must be below 4 GiB. Throws std::bad_alloc.
[[nodiscard]] std::vector<std::byte> frameGlb(std::string json, std::span<const std::byte> binary,
                                              std::span<const std::byte> otherChunks = {});

/// The folder of a file; "." for a bare file name.
[[nodiscard]] std::filesystem::path folderOf(const std::filesystem::path& file);

/// Resolves a relative URI of the asset at `asset`. Errors: badInput for another URI, or if the
/// path leaves the asset's folder, literally or through a symbolic link. Throws std::bad_alloc.
[[nodiscard]] Result<std::filesystem::path> fileOfUri(const std::filesystem::path& asset,
                                                      const std::string& uri);
/// Reads a URI of the asset: a data URI, or a file as of fileOfUri(). If `length` is given, reads
/// only the first bytes of a file, and a shorter file is an error. Throws std::bad_alloc.
[[nodiscard]] Result<std::vector<std::byte>> readUri(const std::filesystem::path& asset,
                                                     const std::string& uri,
                                                     std::optional<std::size_t> length = {});
/// Supplies the files in the asset's folder.
[[nodiscard]] ExternalFile filesBeside(const std::filesystem::path& asset);

} // namespace lichen
