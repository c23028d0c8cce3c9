// SPDX-License-Identifier: MIT
// Decodes LichenMap::mipKept0 to mipKept2 as the shader does.
#include "level_kept.h"

#include "sampling/level_kept.h"

namespace lichen::texton {
namespace {

float channelKept(const shader::uvec4& bytes, float level) {
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

std::array<float, 3> levelKept(const shader::LichenMap& map, float level) {
  return {channelKept(map.mipKept0, level), channelKept(map.mipKept1, level),
          channelKept(map.mipKept2, level)};
}

} // namespace lichen::texton
