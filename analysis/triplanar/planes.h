// SPDX-License-Identifier: MIT
// The three planes of a triplanar noise at a point, and the blend of their values: the CPU twin of
// shaders_glsl/mapping/triplanar.glsl and noise/triplanar.glsl.
#pragma once

#include <lichen/shader_parameters.h>
#include <lichen/tile_footprint.h>
#include <lichen/triplanar_footprint.h>

#include <array>

namespace lichen::triplanar {

/// The noise in the plane perpendicular to one axis.
struct Plane {
  float weight = 0.0f;               ///< the squares of the weights sum to 1; 0: skipped
  shader::LichenMaterial material{}; ///< as on texture coordinates
  TileFootprint at;
  std::array<std::array<float, 3>, 2> axes{}; ///< in space: the exemplar's right and up
  float seen = 0.0f; ///< share of a slope's variance that the surface shows
};

/// Returns the planes perpendicular to x, y and z.
[[nodiscard]] std::array<Plane, 3> planesAt(const TriplanarFootprint& at,
                                            const shader::LichenTriplanarMaterial& material,
                                            const shader::LichenNoise& noise);

/// Blends `gaussianOf(plane)` of each plane with a weight. It returns four floats: three Gaussian
/// values and the share of their variance that filtering loses. The result has the same four
/// floats.
template <class GaussianOf>
[[nodiscard]] std::array<float, 4> blendedGaussian(const std::array<Plane, 3>& planes,
                                                   const GaussianOf& gaussianOf) {
  // [HN18] eq. 8; the squares of the weights sum to 1.
  std::array<float, 4> blend{0.5f, 0.5f, 0.5f, 0.0f};
  for (const Plane& plane : planes) {
    if (plane.weight == 0.0f)
      continue;
    const std::array<float, 4> gaussian = gaussianOf(plane);
    for (std::size_t c = 0; c < 3; ++c)
      blend[c] += plane.weight * (gaussian[c] - 0.5f);
    blend[3] += plane.weight * plane.weight * gaussian[3];
  }
  return blend;
}

/// Blends `slopesOf(plane)` of each plane with a weight: two slopes and the variance lost to
/// filtering. Returns the gradient in space and the lost variance on the surface. [M20]
template <class SlopesOf>
[[nodiscard]] std::array<float, 4> blendedSlopes(const std::array<Plane, 3>& planes,
                                                 const SlopesOf& slopesOf) {
  std::array<float, 4> blend{};
  for (const Plane& plane : planes) {
    if (plane.weight == 0.0f)
      continue;
    const std::array<float, 4> slopes = slopesOf(plane);
    for (std::size_t k = 0; k < 3; ++k)
      blend[k] += plane.weight * (slopes[0] * plane.axes[0][k] + slopes[1] * plane.axes[1][k]);
    blend[3] += plane.weight * plane.weight * plane.seen * slopes[2];
  }
  return blend;
}

} // namespace lichen::triplanar
