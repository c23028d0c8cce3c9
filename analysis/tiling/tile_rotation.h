// SPDX-License-Identifier: MIT
// Rotated tiles: the CPU twin of shaders_glsl/noise/tile_rotation.glsl.
#pragma once

#include <lichen/shader_parameters.h>

#include <array>

namespace lichen::tiling {

[[nodiscard]] inline bool rotatesTiles(const shader::LichenMaterial& material) {
  return tilingPart(material).tileRotation > 1;
}

/// Converts a position on the plane [tiles] to a position in the exemplar of a rotated tile, or
/// slopes in that exemplar, whose y points up, against v, to slopes on the plane. `turn`: cosine
/// and sine.
[[nodiscard]] inline std::array<float, 2> turned(const std::array<float, 2>& xy,
                                                 const std::array<float, 2>& turn) {
  return {turn[0] * xy[0] - turn[1] * xy[1], turn[0] * xy[1] + turn[1] * xy[0]};
}

} // namespace lichen::tiling
