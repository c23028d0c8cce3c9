// SPDX-License-Identifier: MIT
// The CPU twin of shaders_glsl/noise/solid_cosines.glsl.
#pragma once

#include "sampling/solid_point.h"

#include <lichen/local_random_phase_map.h>
#include <lichen/shader_parameters.h>
#include <lichen/solid_footprint.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace lichen::local_random_phase {

/// The sums over the cosines around a point. `texels`: cosineTexels() of a map. `octaves`: the
/// number of cosines of each octave.
[[nodiscard]] solid::Sum solidSumAt(std::span<const std::array<CosineTexel, kRowCosines>> texels,
                                    const std::vector<int>& octaves, std::uint32_t variants,
                                    const shader::LichenNoise& noise, const shader::LichenMap& map,
                                    const shader::LichenMaterial& material,
                                    const SolidFootprint& at);

} // namespace lichen::local_random_phase
