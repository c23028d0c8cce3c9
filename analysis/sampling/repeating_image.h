// SPDX-License-Identifier: MIT
// A 2-D table with its mips, as a trilinear sampler that repeats sees it.
#pragma once

#include <lichen/bundle.h>

#include <array>
#include <vector>

namespace lichen {

/// Texels of a table, red, green and blue with 0 where it has fewer channels, and 1.
[[nodiscard]] std::vector<std::array<float, 4>> texelsOf(const Table& table, std::uint32_t level);

/// a + t (b - a). Inline: it is called ten times and more for every fetch of a synthesis, of which
/// a call would be a fifth of the time.
[[nodiscard]] inline std::array<float, 4> mix(const std::array<float, 4>& a,
                                              const std::array<float, 4>& b, float t) {
  std::array<float, 4> result{};
  for (std::size_t c = 0; c < result.size(); ++c)
    result[c] = a[c] + t * (b[c] - a[c]);
  return result;
}

/// Immutable: any number of threads may fetch from it.
class RepeatingImage {
public:
  using Value = std::array<float, 4>;

  /// Throws std::bad_alloc.
  explicit RepeatingImage(const Table& table);

  /// The value at (u, v), one unit being the whole image; `lod` in mip levels, clamped to those
  /// that there are.
  [[nodiscard]] Value at(float u, float v, float lod) const;
  [[nodiscard]] const std::vector<Value>& texels(std::size_t level) const {
    return mips_[level].texels;
  }

private:
  struct Mip {
    int width = 0;
    int height = 0;
    std::vector<Value> texels;
  };
  [[nodiscard]] static Value bilinear(const Mip& mip, float u, float v);

  std::vector<Mip> mips_;
};

} // namespace lichen
