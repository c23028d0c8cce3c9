// SPDX-License-Identifier: MIT
// Whole files in and out, so that an interrupted run leaves the old file whole and no partial one.
#pragma once

#include <lichen/result.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

namespace lichen {

/// Reads a regular file. Errors: badInput when it is absent, a folder or unreadable, or longer than
/// `maxBytes`; resources when memory does not suffice.
[[nodiscard]] Result<std::vector<std::byte>> readFile(const std::filesystem::path& path,
                                                      std::size_t maxBytes = std::size_t(4) << 30);

/// Writes `bytes` to a temporary file beside `path`, flushes it, and renames it over `path`.
/// Errors: environment when the folder is absent or cannot be written, resources when the disk is
/// full; in both the old file, if any, is untouched and the temporary one is removed.
[[nodiscard]] Result<void> replaceFile(const std::filesystem::path& path,
                                       std::span<const std::byte> bytes);

} // namespace lichen
