// SPDX-License-Identifier: MIT
// What images need before they are decoded, against what the system has.
#pragma once

#include <lichen/result.h>

#include <cstdint>
#include <optional>
#include <string>

namespace lichen::cli {

/// Bytes a pixel that a method needs to bake an exemplar; 0 where nothing is baked.
struct BakeMemory {
  double map = 0.0;     ///< of each map
  double largest = 0.0; ///< and once, of the largest map
};

/// Adds up what the images of one exemplar need, and refuses the first one that is too much.
class MemoryNeed {
public:
  /// `keptPixels` are those of each map once it is cut or resampled; nothing where it stays as it
  /// is. `available` is in bytes; nothing: every image is accepted.
  MemoryNeed(const BakeMemory& bake, std::optional<std::uint64_t> keptPixels,
             std::optional<std::uint64_t> available)
      : bake_(bake), keptPixels_(keptPixels), available_(available) {}

  /// Of the file `name`. Errors: resources, with what is needed and what there is.
  [[nodiscard]] Result<void> add(const std::string& name, int width, int height);

private:
  BakeMemory bake_;
  std::optional<std::uint64_t> keptPixels_;
  std::optional<std::uint64_t> available_;
  std::uint64_t read_ = 0; ///< pixels of all images so far
  std::uint64_t kept_ = 0; ///< likewise, of their maps
  std::uint64_t largestKept_ = 0;
};

} // namespace lichen::cli
