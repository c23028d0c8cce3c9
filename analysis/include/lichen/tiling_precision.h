// SPDX-License-Identifier: MIT
// Measures what the stored tables of a map lose of its exemplar.
#pragma once

#include <lichen/bundle.h>
#include <lichen/exemplar.h>
#include <lichen/result.h>

#include <optional>

namespace lichen {

/// Compares the decoded texels of a map's Gaussian image with the exemplar. At one pixel per texel
/// these are the noise's values at the vertices of its lattice.
struct PrecisionLoss {
  double mean = 0.0;     ///< the largest difference of a channel's mean, in decoded units
  double variance = 0.0; ///< missing share of the decoded variance, over all channels
  /// Sliced Wasserstein-2 distance between the stored values (lichen/quality.h).
  double colorDistance = 0.0;
  /// Root mean square error of a decoded pixel, over the exemplar's standard deviation; only if the
  /// exemplar's borders were not blended.
  std::optional<double> roundTrip;
};

/// Measures map `map` of noise `noise`, which was baked from `exemplar`; `periodic` is
/// TilingBake::exemplarWasPeriodic. The loss includes rounding to the bake's precision and the
/// errors of table and transport: bake with 8 and with 16 bits to compare. All are 0 for a constant
/// exemplar. Errors: usage for an exemplar with another size or number of channels, and errors of
/// TilingEvaluator::create(); resources if memory runs out.
[[nodiscard]] Result<PrecisionLoss> precisionLoss(const Bundle& bundle, std::size_t noise,
                                                  std::size_t map, const MapExemplar& exemplar,
                                                  bool periodic);

} // namespace lichen
