// SPDX-License-Identifier: MIT
// The CPU twin of shaders_glsl/noise/solid_vertices.glsl.
#pragma once

#include <lichen/shader_parameters.h>

#include <array>
#include <cstdint>

namespace lichen::local_random_phase {

/// The cell of octave 0 that holds a point, modulo 2^32, and the place in it.
struct SolidCell {
  std::array<std::uint32_t, 3> cell{};
  std::array<float, 3> inside{}; ///< in [0, 1)
};

/// `position`: [tiles] from the tile origin; along z a tile is as long as it is wide.
[[nodiscard]] SolidCell solidCellAt(const shader::LichenMaterial& material,
                                    const std::array<float, 3>& position);

/// One vertex of a lattice.
struct SolidVertex {
  std::uint32_t state = 0;       ///< of its random numbers
  std::array<float, 3> offset{}; ///< [tiles] from it to the point
  float weight = 0.0f;           ///< its window there
};

/// The mean square frequency of a window along one axis [cycles^2 / cube^2], as kWindowSpread. By
/// quadrature.
inline constexpr float kSolidWindowSpread = 0.3265f;

/// Cubes of octave 0 per tile along each axis.
[[nodiscard]] std::array<float, 3> cubesPerTile(const shader::LichenMaterial& material);

/// The four vertices of the tetrahedron around a point in the lattice of an octave.
[[nodiscard]] std::array<SolidVertex, 4> solidVerticesAt(const SolidCell& cell, int octave,
                                                         const shader::LichenMaterial& material);

} // namespace lichen::local_random_phase
