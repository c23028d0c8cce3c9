// SPDX-License-Identifier: MIT
// Decodes a level of a table and fills its texels to four components.
#include "texels.h"

#include <algorithm>

namespace lichen {

std::vector<Texel> texelsOf(const Table& table, std::uint32_t level, Alpha alpha) {
  const std::vector<float> values = decodeLevel(table, level);
  const auto channels = std::size_t(channelCount(table.format));
  std::vector<Texel> texels(values.size() / channels, Texel{0.0f, 0.0f, 0.0f, 1.0f});
  const bool hasAlpha = alpha == Alpha::lastChannel;
  const std::size_t colors = hasAlpha ? channels - 1 : channels;
  for (std::size_t i = 0; i < texels.size(); ++i) {
    std::copy_n(&values[i * channels], colors, texels[i].begin());
    if (hasAlpha)
      texels[i][3] = values[i * channels + colors];
  }
  return texels;
}

} // namespace lichen
