// SPDX-License-Identifier: MIT
// The CPU twin of shaders_glsl/noise/kernel_pattern.glsl.
#pragma once

#include "kernel_impacts.h"
#include "sampling/wave.h"

#include <lichen/multiple_kernels_map.h>

#include <span>

namespace lichen::multiple_kernels {

/// The sum of a pattern's cosines.
struct PatternSum {
  std::array<float, 3> gaussian{};         ///< less its mean
  std::array<float, 3> alongX{}, alongY{}; ///< derivatives [1 / tile]
  float squares = 0.0f, lost = 0.0f;       ///< the variance, and what the footprint takes of it
};

/// lichenPatternAt
[[nodiscard]] PatternSum patternAt(std::span<const PatternCosine> cosines, const KernelPlace& place,
                                   const WaveFootprint& footprint,
                                   const shader::LichenMaterial& material);

} // namespace lichen::multiple_kernels
