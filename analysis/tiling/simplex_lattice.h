// SPDX-License-Identifier: MIT
// Finds the triangle around a point and the tiles of its vertices: the CPU twin of
// shaders_glsl/noise/simplex_lattice.glsl.
#pragma once

#include <lichen/shader_parameters.h>

#include <array>

namespace lichen::tiling {

/// The three vertices around a point: the position at which each tile is fetched, in tile space,
/// and the blend weights, which sum to 1.
struct Taps {
  std::array<std::array<float, 2>, 3> position{};
  std::array<std::array<float, 2>, 3> turn{}; ///< cosine and sine of each tile's angle
  std::array<float, 3> weight{};
  float norm = 1.0f; ///< square root of the sum of the squared weights, [HN18] eq. 6
};

[[nodiscard]] Taps tapsAt(const shader::LichenMaterial& material, const shader::LichenNoise& noise,
                          const std::array<float, 2>& position);

} // namespace lichen::tiling
