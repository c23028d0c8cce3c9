// SPDX-License-Identifier: MIT
// The CPU twin of shaders_glsl/noise/solid_kernels.glsl.
#pragma once

#include "sampling/solid_point.h"

#include <lichen/multiple_kernels_map.h>

#include <span>

namespace lichen::multiple_kernels {

/// The sums over the impacts of all kernels around a point. `rows`: kernelRows() of a map.
[[nodiscard]] solid::Sum solidSumAt(std::span<const KernelRow> rows,
                                    const shader::LichenNoise& noise, const shader::LichenMap& map,
                                    const shader::LichenMaterial& material,
                                    const SolidFootprint& at);

/// A window of the kind gabor in space, over that in the plane: how much wider it is, so that
/// planes have the spread of the window in the plane, and the integral of its square where both
/// have the same width. Ratios of Beta functions.
inline constexpr float kSolidWider = 1.0350983f; ///< sqrt(15 / 14)
inline constexpr float kSolidIntegral = 0.636518f;

} // namespace lichen::multiple_kernels
