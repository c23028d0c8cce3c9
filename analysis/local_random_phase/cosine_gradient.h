// SPDX-License-Identifier: MIT
// The CPU twin of shaders_glsl/noise/cosine_gradient.glsl.
#pragma once

#include "cosine_vertices.h"

#include <lichen/local_random_phase_map.h>

#include <array>
#include <span>
#include <vector>

namespace lichen::local_random_phase {

/// Derivatives of Gaussian values along x and y [1 / tile].
struct CosineSlopes {
  std::array<float, 3> alongX{}, alongY{};
};

/// Slopes of the cosines' sum in the cell; `octaves` has the number of cosines of each.
[[nodiscard]] CosineSlopes
cosineSlopesAt(std::span<const std::array<CosineTexel, kRowCosines>> texels,
               const std::vector<int>& octaves, std::uint32_t variants, const CosineCell& cell,
               const WaveFootprint& footprint, const shader::LichenMaterial& material);

} // namespace lichen::local_random_phase
