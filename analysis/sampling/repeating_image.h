// SPDX-License-Identifier: MIT
// A 2-D table with its mips, as a repeating trilinear sampler reads it.
#pragma once

#include <lichen/bundle.h>

#include <array>
#include <vector>

namespace lichen {

/// Where the fourth component of a texel comes from: it is 1, or the table's last channel, as in
/// Gaussian images.
enum class Alpha { one, lastChannel };

/// Returns the texels of a table: red, green and blue, which are 0 where the table has fewer
/// channels, and alpha.
[[nodiscard]] std::vector<std::array<float, 4>> texelsOf(const Table& table, std::uint32_t level,
                                                         Alpha alpha = Alpha::one);

/// a + t (b - a). Inline: a synthesis calls it ten or more times per fetch, and a real call would
/// take a fifth of the time.
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
  explicit RepeatingImage(const Table& table, Alpha alpha = Alpha::one);

  /// Returns the value at (u, v), where the whole image is one unit. `lod` is in mip levels and is
  /// clamped to those that exist.
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
