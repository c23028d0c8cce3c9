// SPDX-License-Identifier: MIT
// The CPU twin of shaders_glsl/noise/surface_kernels.glsl.
#pragma once

#include <lichen/multiple_kernels_map.h>
#include <lichen/shader_parameters.h>
#include <lichen/surface_footprint.h>

#include <array>
#include <span>

namespace lichen::multiple_kernels {

/// The Gaussian value, and the share of its variance that the footprint loses. `rows`: kernelRows()
/// of a map.
[[nodiscard]] std::array<float, 4> surfaceGaussianAt(std::span<const KernelRow> rows,
                                                     const shader::LichenNoise& noise,
                                                     const shader::LichenMaterial& material,
                                                     const SurfaceFootprint& at);

} // namespace lichen::multiple_kernels
