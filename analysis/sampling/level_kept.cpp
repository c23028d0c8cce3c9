// SPDX-License-Identifier: MIT
// LichenMap::mipKept0 to mipKept2, read as the shader reads them.
#include "level_kept.h"

#include <algorithm>
#include <array>

namespace lichen {
namespace {

float textonKept(const shader::uvec4& bytes, float level) {
  const int mip = int(level);
  const float fine = mipKept(bytes, mip);
  const float coarse = mipKept(bytes, mip + 1);
  const float ratio = fine > 0.0f ? coarse / fine : 0.0f;
  const float covariance =
      coarse * coarse + 0.5f * ratio * ratio * ratio * (fine * fine - coarse * coarse);
  const float t = level - float(mip);
  const float rest = 1.0f - t;
  return rest * rest * fine * fine + 2.0f * t * rest * covariance + t * t * coarse * coarse;
}

} // namespace

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

std::array<float, 3> textonKept(const shader::LichenMap& map, float level) {
  return {textonKept(map.mipKept0, level), textonKept(map.mipKept1, level),
          textonKept(map.mipKept2, level)};
}

} // namespace lichen
