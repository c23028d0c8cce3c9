// SPDX-License-Identifier: MIT
// The CPU twin of shaders_glsl/noise/solid_cosines.glsl, of mapping/solid.glsl too.
#pragma once

#include <lichen/local_random_phase_map.h>
#include <lichen/shader_parameters.h>
#include <lichen/solid_footprint.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace lichen::local_random_phase {

/// Sums over the cosines around a point.
struct SolidSum {
  std::array<float, 3> gaussian{};   ///< Gaussian values less their mean
  float depthSlope = 0.0f;           ///< of slopes: that along z, stored
  float squares = 0.0f, lost = 0.0f; ///< squared amplitudes, and what the footprint takes of them
};

/// `texels`: cosineTexels() of a map. `octaves`: the number of cosines of each octave.
[[nodiscard]] SolidSum solidSumAt(std::span<const std::array<CosineTexel, kRowCosines>> texels,
                                  const std::vector<int>& octaves, std::uint32_t variants,
                                  const shader::LichenNoise& noise, const shader::LichenMap& map,
                                  const shader::LichenMaterial& material, const SolidFootprint& at);

/// Decoded slopes and the slope along z -> the gradient in space, and the lost variance.
[[nodiscard]] std::array<float, 4> slopesInSpace(const std::array<float, 4>& slopes,
                                                 float depthSlope,
                                                 const shader::LichenMaterial& material);

} // namespace lichen::local_random_phase
