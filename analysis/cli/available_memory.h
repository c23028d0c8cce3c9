// SPDX-License-Identifier: MIT
// The memory that the system can still give this process.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace lichen::cli {

/// Returns bytes, or nothing if the system does not report them. On Linux: the minimum of
/// MemAvailable, the memory left in the process's control group (version 1 or 2) and its ancestors,
/// and what is left of the limit on the address space. `proc` and `cgroup` are the mount points of
/// the kernel's files.
[[nodiscard]] std::optional<std::uint64_t>
availableMemory(const std::filesystem::path& proc = "/proc",
                const std::filesystem::path& cgroup = "/sys/fs/cgroup");

} // namespace lichen::cli
