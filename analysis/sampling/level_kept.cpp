// SPDX-License-Identifier: MIT
// Decodes LichenMap::mipKept0 as the shader does.
#include "level_kept.h"

#include <algorithm>
#include <array>

namespace lichen {

float mipKept(const shader::uvec4& bytes, int mip) {
  const std::array<shader::uint, 4> words{bytes.x, bytes.y, bytes.z, bytes.w};
  const int byte = std::min(mip, LICHEN_MAX_MIPS - 1);
  return float((words[std::size_t(byte / 4)] >> (8 * (byte % 4))) & 255u) / 255.0f;
}

float levelKept(const shader::LichenMap& map, float level) {
  const int mip = int(level);
  const float below = mipKept(map.mipKept0, mip);
  const float above = mipKept(map.mipKept0, mip + 1);
  const float rest = 1.0f - (level - float(mip));
  return above * above + rest * rest * (below * below - above * above);
}

} // namespace lichen
