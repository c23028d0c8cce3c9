// SPDX-License-Identifier: MIT
// Decodes LichenMap::mipRetained0 to mipRetained2 as the shader does.
#include "level_retained.h"

#include "sampling/level_retained.h"

namespace lichen::texton {
namespace {

float channelRetained(const shader::uvec4& bytes, float level) {
  const int mip = int(level);
  const float fine = mipRetained(bytes, mip);
  const float coarse = mipRetained(bytes, mip + 1);
  const float ratio = fine > 0.0f ? coarse / fine : 0.0f;
  const float covariance =
      coarse * coarse + 0.5f * ratio * ratio * ratio * (fine * fine - coarse * coarse);
  const float t = level - float(mip);
  const float rest = 1.0f - t;
  return rest * rest * fine * fine + 2.0f * t * rest * covariance + t * t * coarse * coarse;
}

} // namespace

std::array<float, 3> levelRetained(const shader::LichenMap& map, float level) {
  return {channelRetained(map.mipRetained0, level), channelRetained(map.mipRetained1, level),
          channelRetained(map.mipRetained2, level)};
}

} // namespace lichen::texton
