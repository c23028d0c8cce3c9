// SPDX-License-Identifier: MIT
// Checks, before images are decoded, that the system has the memory they need.
#pragma once

#include <lichen/result.h>
#include <lichen/suitability.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace lichen {

/// Bytes per pixel that a method needs to bake an exemplar; 0 if nothing is baked.
struct BakeMemory {
  double map = 0.0;     ///< for each map
  double largest = 0.0; ///< once more for the largest map
};

/// Sums the memory for the images of one exemplar and refuses the first image that exceeds it.
class MemoryNeed {
public:
  /// `keptPixels` is the pixel count of each map after cropping or resampling; nothing if maps keep
  /// their size. `available` is in bytes; nothing means no limit. Messages have `words`.
  MemoryNeed(const BakeMemory& bake, std::optional<std::uint64_t> keptPixels,
             std::optional<std::uint64_t> available, SettingWords words)
      : bake_(bake), keptPixels_(keptPixels), available_(available), words_(words) {}

  /// Adds the image of the file `name`. Errors: resources, with the needed and the available
  /// memory.
  [[nodiscard]] Result<void> add(const std::string& name, int width, int height);

private:
  BakeMemory bake_;
  std::optional<std::uint64_t> keptPixels_;
  std::optional<std::uint64_t> available_;
  SettingWords words_;
  std::uint64_t read_ = 0; ///< pixels of all images so far
  std::uint64_t kept_ = 0; ///< pixels of all maps so far, after cropping or resampling
  std::uint64_t largestKept_ = 0;
};

/// Returns bytes that the system can still give this process, or nothing if it does not say. On
/// Linux: the minimum of MemAvailable, the memory left in the process's control group (version 2)
/// and its ancestors, and what is left of the limit on the address space. `proc` and `cgroup`
/// are the mount points of the kernel's files.
[[nodiscard]] std::optional<std::uint64_t>
availableMemory(const std::filesystem::path& proc = "/proc",
                const std::filesystem::path& cgroup = "/sys/fs/cgroup");

} // namespace lichen
