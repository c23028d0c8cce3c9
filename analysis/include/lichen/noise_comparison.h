// SPDX-License-Identifier: MIT
// A noise measured against the exemplar that it was made from.
#pragma once

#include <lichen/bundle.h>
#include <lichen/map_picture.h>
#include <lichen/measures.h>
#include <lichen/progress.h>
#include <lichen/texton_comparison.h>

#include <optional>

namespace lichen {

struct NoiseComparison {
  MapLook look;
  SrgbImage exemplar; ///< as a picture
  SrgbImage result;   ///< likewise
  /// As measureResult() gives them, and of tiling lattice_visibility; of a texton as
  /// measureGaussianResult(), and model_error and flatness.
  std::vector<Measure> measures;
  /// Of a texton: gaussianVersion() as a picture, and other spots of its support.
  std::optional<SrgbImage> gaussian;
  std::optional<KernelComparison> kernels;
};

/// The exemplar's map of the material's noise, synthesized with the material's pattern at four
/// exemplars a side, one texel a pixel, and for lattice_visibility at sixteen; at most 4096 pixels
/// a side each. The noise's encoding is taken for both; of textons the exemplar is resampled to the
/// size that all maps of the noise had. A mix is taken at the material's constant weight, at its
/// first input where that has another source.
/// Errors: usage for an index or a parameter out of range or a map that the noise has not;
/// badInput, naming both, for an exemplar of other channels; resources for memory;
/// environment when `progress` stops it. Deterministic.
[[nodiscard]] Result<NoiseComparison> compareNoise(const Bundle& bundle,
                                                   const MaterialNoise& material,
                                                   const MapExemplar& exemplar,
                                                   const Progress& progress = {});

/// Whether a bake by this method enlarges all maps of a set to the size of the largest.
[[nodiscard]] bool enlargesMaps(Method method);

} // namespace lichen
