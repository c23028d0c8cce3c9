// SPDX-License-Identifier: MIT
// LichenMap::mipKept, read as the shader reads it.
#include "level_kept.h"

#include <algorithm>
#include <array>

namespace lichen {

float mipKept(const shader::LichenMap& map, int mip) {
  const std::array<shader::uint, 4> words{map.mipKept.x, map.mipKept.y, map.mipKept.z,
                                          map.mipKept.w};
  const int byte = std::min(mip, LICHEN_MAX_MIPS - 1);
  return float((words[std::size_t(byte / 4)] >> (8 * (byte % 4))) & 255u) / 255.0f;
}

float levelKept(const shader::LichenMap& map, float level) {
  const int mip = int(level);
  const float below = mipKept(map, mip);
  const float above = mipKept(map, mip + 1);
  const float rest = 1.0f - (level - float(mip));
  return above * above + rest * rest * (below * below - above * above);
}

} // namespace lichen
