// SPDX-License-Identifier: MIT
// Reads and writes whole files, and lists folders. Writing is atomic: an interrupted run leaves the
// old file intact.
#pragma once

#include <lichen/result.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

namespace lichen {

/// Reads a regular file. Errors: badInput if it does not exist, is not a regular file, is
/// unreadable or is longer than `maxBytes`; resources if memory does not suffice. Thread-safe.
[[nodiscard]] Result<std::vector<std::byte>> readFile(const std::filesystem::path& path,
                                                      std::size_t maxBytes = std::size_t(4) << 30);
/// Reads the first `size` bytes of a regular file. Errors as readFile(), but badInput if the file
/// is shorter than `size`, whatever its length.
[[nodiscard]] Result<std::vector<std::byte>> readFileStart(const std::filesystem::path& path,
                                                           std::size_t size);

/// Checks that a folder for output exists; an empty path is the current folder. Errors: environment
/// with the reason; resources if memory does not suffice. Thread-safe.
[[nodiscard]] Result<void> checkFolder(const std::filesystem::path& folder);

/// Writes `bytes` to a temporary file in the folder of `path`, flushes it to disk, and renames it
/// to `path`.
/// Errors: environment if the folder does not exist or is not writable; resources if the disk is
/// full or memory does not suffice. On any error the old file is unchanged and no temporary file
/// remains.
/// If the process is killed, a file PATH.part-* may remain. On file systems with unnamed files
/// (ext4, XFS, Btrfs, tmpfs; not NFS, FAT) that is only possible in the moment between naming the
/// temporary file and renaming it.
/// Thread-safe. If several calls write the same path, one of them wins as a whole.
[[nodiscard]] Result<void> replaceFile(const std::filesystem::path& path,
                                       std::span<const std::byte> bytes);

/// The sorted paths of a folder's entries, without "." and "..". Errors: badInput if the folder
/// does not exist, is not a folder or is unreadable; resources if memory does not suffice.
/// Thread-safe.
[[nodiscard]] Result<std::vector<std::filesystem::path>>
listFolder(const std::filesystem::path& folder);

} // namespace lichen
