// SPDX-License-Identifier: MIT
// Whole files in and out, so that an interrupted run leaves the old file whole and no partial one,
// and what a folder holds.
#pragma once

#include <lichen/result.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

namespace lichen {

/// Reads a regular file of at most `maxBytes`. Errors: badInput when it is absent,
/// a folder or unreadable, or longer; resources when memory does not suffice. Thread-safe.
[[nodiscard]] Result<std::vector<std::byte>> readFile(const std::filesystem::path& path,
                                                      std::size_t maxBytes = std::size_t(4) << 30);
/// As above, of a file of any size: its first `size` bytes. badInput too when it has fewer.
[[nodiscard]] Result<std::vector<std::byte>> readFileStart(const std::filesystem::path& path,
                                                           std::size_t size);

/// Writes `bytes` to a new file in the folder of `path`, flushes it to the disk, and renames it
/// over `path`. Errors: environment when the folder is absent or cannot be written, resources when
/// the disk is full or memory does not suffice; in all the old file, if any, is untouched and
/// nothing is left beside it. A process that is killed leaves nothing either, where the file system
/// has files without a name (ext4, XFS, Btrfs, tmpfs; not NFS, FAT); elsewhere a file PATH.part-*
/// may stay. Thread-safe; of several calls for one path at the same time one wins, whole.
[[nodiscard]] Result<void> replaceFile(const std::filesystem::path& path,
                                       std::span<const std::byte> bytes);

/// The paths of a folder's entries, without "." and "..", sorted. Errors: badInput when it is
/// absent, no folder or unreadable; resources when memory does not suffice. Thread-safe.
[[nodiscard]] Result<std::vector<std::filesystem::path>>
listFolder(const std::filesystem::path& folder);

} // namespace lichen
