// SPDX-License-Identifier: MIT
// What images need before they are decoded, against what the system has.
#pragma once

#include <lichen/result.h>

#include <cstdint>
#include <optional>
#include <string>

namespace lichen::cli {

/// What is made of an exemplar.
enum class ExemplarUse { comparison, tiling, textons };

/// Adds up what the images of one exemplar need, and refuses the first one that is too much.
class MemoryNeed {
public:
  /// `keptPixels` are those of each map once it is cut or resampled; nothing where it stays as it
  /// is. `available` is in bytes; nothing: every image is accepted.
  MemoryNeed(ExemplarUse use, std::optional<std::uint64_t> keptPixels,
             std::optional<std::uint64_t> available)
      : use_(use), keptPixels_(keptPixels), available_(available) {}

  /// Of the file `name`. Errors: resources, with what is needed and what there is.
  [[nodiscard]] Result<void> add(const std::string& name, int width, int height);

private:
  ExemplarUse use_;
  std::optional<std::uint64_t> keptPixels_;
  std::optional<std::uint64_t> available_;
  std::uint64_t read_ = 0; ///< pixels of all images so far
  std::uint64_t kept_ = 0; ///< likewise, of their maps
  std::uint64_t largestKept_ = 0;
};

} // namespace lichen::cli
