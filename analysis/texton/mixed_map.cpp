// SPDX-License-Identifier: MIT
// A linear, clamping sampler of a mix's table; see mixed_map.h. [GLM17] section 7.
#include "mixed_map.h"

#include <algorithm>
#include <cmath>

namespace lichen::texton {
namespace {

using Amplitudes = std::array<float, LICHEN_MAX_MIPS>;

/// Packs retained amplitudes of mips as LichenMap stores them.
shader::uvec4 keptBytes(const Amplitudes& kept) {
  std::array<shader::uint, 4> words{};
  for (std::size_t mip = 0; mip < kept.size(); ++mip)
    words[mip / 4] |= shader::uint(std::lround(255.0f * kept[mip])) << (8 * (mip % 4));
  return {words[0], words[1], words[2], words[3]};
}

} // namespace

MixRows::MixRows(const NoiseMap& map) {
  const std::size_t laterSteps = map.as<TextonMap>().laterSteps.size();
  if (laterSteps == 0)
    return;
  steps_ = laterSteps + 1;
  values_ = decodeLevel(mixTable(map), 0);
}

float MixRows::stepOf(const MixPlace& mix) const {
  return std::clamp(mix.weight, 0.0f, 1.0f) * float(steps_ - 1);
}

MixRows::Row MixRows::row(float atStep, std::size_t index) const {
  const auto below = std::size_t(atStep);
  const std::size_t above = std::min(below + 1, steps_ - 1);
  const float t = atStep - float(below);
  Row result{};
  for (std::size_t c = 0; c < result.size(); ++c) {
    const float low = values_[(index * steps_ + below) * result.size() + c];
    const float high = values_[(index * steps_ + above) * result.size() + c];
    result[c] = low + t * (high - low);
  }
  return result;
}

shader::LichenMap MixRows::at(shader::LichenMap map, const MixPlace& mix) const {
  if (steps_ == 0)
    return map;
  const float atStep = stepOf(mix);
  const Row mean = row(atStep, LICHEN_MIX_MEAN);
  const Row deviation = row(atStep, LICHEN_MIX_DEVIATION);
  map.row0.w += mean[0];
  map.row1.w += mean[1];
  map.row2.w += mean[2];
  map.row0.x *= deviation[0];
  map.row1.y *= deviation[1];
  map.row2.z *= deviation[2];
  map.sumFactor = {1.0f / deviation[0], 1.0f / deviation[1], 1.0f / deviation[2], 0.0f};
  std::array<Amplitudes, 3> kept{};
  for (std::size_t mip = 0; mip < LICHEN_MAX_MIPS; ++mip) {
    const Row ofMip = row(atStep, LICHEN_MIX_RETAINED + mip);
    for (std::size_t c = 0; c < kept.size(); ++c)
      kept[c][mip] = ofMip[c];
  }
  map.mipRetained0 = keptBytes(kept[0]);
  map.mipRetained1 = keptBytes(kept[1]);
  map.mipRetained2 = keptBytes(kept[2]);
  return map;
}

std::array<float, 2> MixRows::meanSlope(const MixPlace& mix) const {
  if (steps_ == 0 || mix.weight < 0.0f || mix.weight > 1.0f)
    return {};
  const float last = float(steps_ - 1);
  const float below = std::min(std::floor(stepOf(mix)), last - 1.0f);
  const float rise = row(below + 1.0f, LICHEN_MIX_MEAN)[0] - row(below, LICHEN_MIX_MEAN)[0];
  return {rise * last * mix.gradient[0], rise * last * mix.gradient[1]};
}

} // namespace lichen::texton
