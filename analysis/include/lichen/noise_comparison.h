// SPDX-License-Identifier: MIT
// Compares a noise with the exemplar that it was made from.
#pragma once

#include <lichen/bundle.h>
#include <lichen/map_picture.h>
#include <lichen/measures.h>
#include <lichen/progress.h>

#include <optional>

namespace lichen {

struct NoiseComparison {
  MapLook look;
  SrgbImage exemplar; ///< as a picture
  SrgbImage result;   ///< as a picture
  /// Tiling: measureResult() and lattice_visibility. Quilting: measureResult() and cut_mismatch.
  /// Textons: measureGaussianResult(), model_error and flatness. Multiple kernels, and local random
  /// phase without a structure: measureGaussianResult(), but measureResult() if their spectrum was
  /// given. Local random phase with a structure: measureResult().
  std::vector<Measure> measures;
  /// The exemplar's Gaussian version, if the noise has random phases.
  std::optional<SrgbImage> gaussian;
};

/// Synthesizes the exemplar's map from the material's noise and pattern, and measures it. The
/// result spans four exemplars per side, or sixteen for lattice_visibility, at one texel per pixel
/// and at most 4096 pixels per side. Both pictures use the noise's encoding. For textons the
/// exemplar is resampled to the common size of the noise's maps. A mix is evaluated at the
/// material's constant weight, or at its first input if the weight has another source.
/// Errors: usage for an index or parameter out of range, or a map that the noise does not have;
/// badInput, naming both, for an exemplar with other channels; resources if memory runs out;
/// environment if `progress` stops it. Deterministic.
[[nodiscard]] Result<NoiseComparison> compareNoise(const Bundle& bundle,
                                                   const MaterialNoise& material,
                                                   const MapExemplar& exemplar,
                                                   const Progress& progress = {});

/// Returns whether a bake with this method enlarges all maps of a set to the size of the largest.
[[nodiscard]] bool enlargesMaps(Method method);

} // namespace lichen
