// SPDX-License-Identifier: MIT
// The CPU twin of shaders_glsl/noise/cosine_vertices.glsl.
#pragma once

#include "sampling/wave.h"

#include <lichen/shader_parameters.h>

#include <array>
#include <cstdint>

namespace lichen::local_random_phase {

/// The cell of octave 0 that holds a point, modulo 2^32, and the place in it.
struct CosineCell {
  std::int32_t i = 0, j = 0;
  float column = 0.0f, row = 0.0f; ///< in [0, 1)
};

/// `position`: [tiles] from the tile origin.
[[nodiscard]] CosineCell cosineCellAt(const shader::LichenMaterial& material,
                                      const std::array<float, 2>& position);

/// One vertex of a lattice.
struct CosineVertex {
  std::uint32_t state = 0;       ///< of its random numbers
  std::uint32_t color = 0;       ///< 0, 1 and 2 around each point, but for the ends of a period
  std::array<float, 2> offset{}; ///< [tiles] from it to the point
  float weight = 0.0f;           ///< its window there
};

/// The three vertices around a point in the lattice of an octave. `stream`: the number that their
/// random numbers belong to.
[[nodiscard]] std::array<CosineVertex, 3> verticesAt(const CosineCell& cell, int octave,
                                                     std::uint32_t stream,
                                                     const shader::LichenMaterial& material);

/// The octaves from the lattice of the material's first to the lattice of `octave`.
[[nodiscard]] int finerOctaves(int octave, const shader::LichenMaterial& material);

/// The squared cycles that a footprint spans of the window of an octave, by its mean square
/// frequency.
[[nodiscard]] float squaredCyclesOfWindow(const WaveFootprint& footprint, int octave,
                                          const shader::LichenMaterial& material);

} // namespace lichen::local_random_phase
