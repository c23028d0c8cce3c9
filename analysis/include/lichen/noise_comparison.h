// SPDX-License-Identifier: MIT
// A noise measured against the exemplar that it was made from.
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
  SrgbImage result;   ///< likewise
  /// As measureResult() gives them, and lattice_visibility.
  std::vector<Measure> measures;
};

/// The exemplar's map of the noise, synthesized with `seed` at four exemplars a side, one texel a
/// pixel, and for lattice_visibility at sixteen; at most 4096 pixels a side each. The noise's
/// encoding is taken for both.
/// Errors: usage for an index out of range or a map that the noise has not; badInput, naming both
/// numbers, for an exemplar of other channels; resources for memory; environment when `progress`
/// stops it. Deterministic.
[[nodiscard]] Result<NoiseComparison> compareNoise(const Bundle& bundle, std::size_t noise,
                                                   std::uint32_t seed, const MapExemplar& exemplar,
                                                   const Progress& progress = {});

} // namespace lichen
