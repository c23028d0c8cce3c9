// SPDX-License-Identifier: MIT
// Rotated tiles: the CPU twin of shaders_glsl/noise/tile_rotation.glsl.
#pragma once

#include <lichen/shader_parameters.h>

#include <array>
#include <cstdint>

namespace lichen::tiling {

[[nodiscard]] inline bool rotatesTiles(const shader::LichenMaterial& material) {
  return tilingPart(material).tileRotation > 1;
}

/// Returns whether rotated texels coincide with unrotated ones. Such tiles rotate about the origin,
/// others about their vertices.
[[nodiscard]] bool rotationsKeepTexels(std::uint32_t tileRotation, float tileAspect);

/// Cosine and sine of rotation `step`, below `steps`, of a full circle; quarter rotations are
/// exact.
[[nodiscard]] std::array<float, 2> tileRotationAt(std::uint32_t step, std::uint32_t steps);

/// Converts an offset on the plane [tiles] to an offset in the exemplar of a rotated tile. `aspect`
/// is width over height of a tile in space, where angles are measured.
[[nodiscard]] std::array<float, 2> turned(const std::array<float, 2>& way,
                                          const std::array<float, 2>& turn, float aspect);

/// Converts slopes in the exemplar of a rotated tile to slopes on the plane. Y points up, against
/// v.
[[nodiscard]] std::array<float, 2> slopesRotatedBack(float slopeX, float slopeY,
                                                     const std::array<float, 2>& turn);

} // namespace lichen::tiling
