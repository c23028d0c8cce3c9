// SPDX-License-Identifier: MIT
// The texels of a table as a shader's fetch returns them.
#pragma once

#include <lichen/bundle.h>

#include <array>
#include <vector>

namespace lichen {

/// Red, green, blue, alpha.
using Texel = std::array<float, 4>;

/// Where the fourth component of a texel comes from: it is 1, or the table's last channel, as in
/// Gaussian images.
enum class Alpha { one, lastChannel };

/// The texels of a level: red, green and blue, which are 0 where the table has fewer channels, and
/// alpha.
[[nodiscard]] std::vector<Texel> texelsOf(const Table& table, std::uint32_t level,
                                          Alpha alpha = Alpha::one);

/// a + t (b - a). Inline: a synthesis calls it ten or more times per fetch, and a real call would
/// take a fifth of the time.
[[nodiscard]] inline Texel mix(const Texel& a, const Texel& b, float t) {
  Texel result{};
  for (std::size_t c = 0; c < result.size(); ++c)
    result[c] = a[c] + t * (b[c] - a[c]);
  return result;
}

} // namespace lichen
