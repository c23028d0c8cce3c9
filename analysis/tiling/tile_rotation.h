// SPDX-License-Identifier: MIT
// Tiles that each lie turned: the CPU twin of shaders_glsl/noise/tile_rotation.glsl.
#pragma once

#include <lichen/shader_parameters.h>

#include <array>
#include <cstdint>

namespace lichen::tiling {

[[nodiscard]] inline bool turnsTiles(const shader::LichenNoise& noise) {
  return noise.tileRotation > 1;
}

/// Whether turned texels lie where texels that are not turned lie. Such tiles are turned about the
/// origin, others about their vertices.
[[nodiscard]] bool turnsKeepTexels(const shader::LichenNoise& noise);

/// The cosine and sine of step `step`, below `steps`, of the steps of a turn; quarters are exact.
[[nodiscard]] std::array<float, 2> tileTurn(std::uint32_t step, std::uint32_t steps);

/// A way on the plane [tiles] -> in the exemplar of a tile that is turned so; `aspect` is width
/// over height of a tile in space, where angles are.
[[nodiscard]] std::array<float, 2> turned(const std::array<float, 2>& way,
                                          const std::array<float, 2>& turn, float aspect);

/// Slopes in the exemplar of a tile that is turned so -> on the plane. Y points up, against v.
[[nodiscard]] std::array<float, 2> slopesTurnedBack(float slopeX, float slopeY,
                                                    const std::array<float, 2>& turn);

} // namespace lichen::tiling
