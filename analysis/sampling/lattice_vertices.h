// SPDX-License-Identifier: MIT
// The triangle of the simplex lattice around a point: the CPU twin of
// shaders_glsl/noise/simplex_lattice.glsl.
#pragma once

#include <lichen/shader_parameters.h>

#include <array>
#include <cstdint>

namespace lichen {

/// A vertex around a point.
struct LatticeVertex {
  std::uint32_t i = 0, j = 0;    ///< reduced to one period
  std::array<float, 2> period{}; ///< whole periods from there to the vertex [tiles]
  std::array<float, 2> cells{};  ///< from the vertex to the point, in skewed coordinates [cells]
  float weight = 0.0f;           ///< barycentric; the three sum to 1
};

/// The vertices around a position in tiles, relative to the tile origin.
[[nodiscard]] std::array<LatticeVertex, 3> latticeVertices(const shader::LichenMaterial& material,
                                                           const std::array<float, 2>& position);

} // namespace lichen
