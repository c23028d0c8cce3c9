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

float textonKept(const shader::LichenMap& map, float level) {
  const int mip = int(level);
  const float fine = mipKept(map, mip);
  const float coarse = mipKept(map, mip + 1);
  const float ratio = fine > 0.0f ? coarse / fine : 0.0f;
  const float covariance =
      coarse * coarse + 0.5f * ratio * ratio * ratio * (fine * fine - coarse * coarse);
  const float t = level - float(mip);
  const float rest = 1.0f - t;
  return rest * rest * fine * fine + 2.0f * t * rest * covariance + t * t * coarse * coarse;
}

} // namespace lichen
