// SPDX-License-Identifier: MIT
// The fetches of shaders_glsl/interface/fetch.glsl from tables in memory.
#pragma once

#include "glsl.h"
#include "sampling/clamped_volume.h"
#include "sampling/repeating_image.h"

namespace lichen::glsl {

inline vec4 asVec(const Texel& texel) { return {texel[0], texel[1], texel[2], texel[3]}; }
inline vec4 sampled(const RepeatingImage& image, const vec2& uv, Float level) {
  return asVec(image.at(uv.x.v, uv.y.v, level.v));
}
inline vec4 sampled(const ClampedVolume& table, const vec3& uvw, Float level) {
  return asVec(table.at({uvw.x.v, uvw.y.v, uvw.z.v}, level.v));
}
inline vec4 fetched(const RepeatingImage& image, const ivec2& texel) {
  return asVec(image.texel(texel.x, texel.y));
}

} // namespace lichen::glsl
