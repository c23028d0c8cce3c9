// SPDX-License-Identifier: MIT
// Decodes LichenMap::mipRetained0 as the shader does.
#include "level_retained.h"

#include <algorithm>
#include <array>

namespace lichen {

float mipRetained(const shader::uvec4& bytes, int mip) {
  const std::array<shader::uint, 4> words{bytes.x, bytes.y, bytes.z, bytes.w};
  const int byte = std::min(mip, LICHEN_MAX_MIPS - 1);
  return float((words[std::size_t(byte / 4)] >> (8 * (byte % 4))) & 255u) / 255.0f;
}

float levelRetained(const shader::LichenMap& map, float level) {
  const int mip = int(level);
  const float below = mipRetained(map.mipRetained0, mip);
  const float above = mipRetained(map.mipRetained0, mip + 1);
  const float rest = 1.0f - (level - float(mip));
  return above * above + rest * rest * (below * below - above * above);
}

} // namespace lichen
