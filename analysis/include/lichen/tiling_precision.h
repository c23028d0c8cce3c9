// SPDX-License-Identifier: MIT
// What the stored tables of a map have lost of its exemplar.
#pragma once

#include <lichen/bundle.h>
#include <lichen/result.h>
#include <lichen/exemplar.h>

#include <optional>

namespace lichen {

/// The values that the texels of a map's Gaussian image decode to, against the exemplar's: at one
/// pixel a texel these are the noise's colours at the vertices of its lattice.
struct PrecisionLoss {
  double mean = 0.0;     ///< the largest difference of a channel's mean, in decoded units
  double variance = 0.0; ///< share of the decoded variance, over all channels, that is missing
  /// Sliced Wasserstein-2 distance between the stored values (lichen/quality.h).
  double colorDistance = 0.0;
  /// Root mean square of a decoded pixel's error, over the exemplar's deviation; of exemplars whose
  /// borders were not blended.
  std::optional<double> roundTrip;
};

/// Of map `map` of noise `noise`, which was baked from `exemplar`; `periodic` as
/// TilingBake::exemplarWasPeriodic. Rounding to the bake's precision is in it, and what table and
/// transport lose: bake with 8 and with 16 bits to compare. All are 0 for a constant exemplar.
/// Errors: usage for an exemplar of another size or another number of channels, and those of
/// TilingEvaluator::create; resources for memory.
[[nodiscard]] Result<PrecisionLoss> precisionLoss(const Bundle& bundle, std::size_t noise,
                                                  std::size_t map, const MapExemplar& exemplar,
                                                  bool periodic);

} // namespace lichen
