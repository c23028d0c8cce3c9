// SPDX-License-Identifier: MIT
// The impacts of a texton noise that reach a point of a surface: the CPU twin of
// lichenSetSurfacePoint (shaders_glsl/noise/surface_texton.glsl).
#pragma once

#include "impacts.h"
#include "sampling/surface_cubes.h"

namespace lichen::texton {

/// Values that all maps of a surface noise share at one point. Offsets along the tangent plane are
/// in texels, from the centre of the area that the texton covers.
struct SurfaceImpacts {
  Impacts impacts; ///< of a plane with this footprint
  surface::Cubes cubes;
};

[[nodiscard]] SurfaceImpacts surfaceImpactsAt(const SurfaceFootprint& at,
                                              const shader::LichenMaterial& material,
                                              const shader::LichenNoise& noise);

} // namespace lichen::texton
