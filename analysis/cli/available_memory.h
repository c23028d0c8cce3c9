// SPDX-License-Identifier: MIT
// How much memory the system would give this process.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace lichen::cli {

/// Bytes, or nothing where the system does not say: on Linux the least of MemAvailable, of what the
/// process's control group (version 1 or 2) and those around it have left, and of the limit on its
/// address space. `proc` and `cgroup` are where the kernel shows them.
[[nodiscard]] std::optional<std::uint64_t>
availableMemory(const std::filesystem::path& proc = "/proc",
                const std::filesystem::path& cgroup = "/sys/fs/cgroup");

} // namespace lichen::cli
