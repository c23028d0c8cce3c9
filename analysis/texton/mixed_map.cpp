// SPDX-License-Identifier: MIT
// A linear, clamping sampler of a mix's table; see mixed_map.h. [GLM17] section 7.
#include "mixed_map.h"

#include <algorithm>
#include <cmath>

namespace lichen::texton {
namespace {

/// packUnorm4x8 of GLSL.
shader::uint packedBytes(const std::array<float, 4>& values) {
  shader::uint word = 0;
  for (std::size_t k = 0; k < 4; ++k)
    word |= shader::uint(std::lround(std::clamp(values[k], 0.0f, 1.0f) * 255.0f)) << (8 * k);
  return word;
}

} // namespace

MixRows::MixRows(const NoiseMap& map) {
  if (map.laterSteps.empty())
    return;
  steps_ = map.laterSteps.size() + 1;
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
  map.mipKept = {
      packedBytes(row(atStep, LICHEN_MIX_KEPT)), packedBytes(row(atStep, LICHEN_MIX_KEPT + 1)),
      packedBytes(row(atStep, LICHEN_MIX_KEPT + 2)), packedBytes(row(atStep, LICHEN_MIX_KEPT + 3))};
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
