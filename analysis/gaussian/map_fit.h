// SPDX-License-Identifier: MIT
// Fits the Gaussian image and the inverse table of one map to each other.
#pragma once

#include "cross_covariance.h"
#include "exemplar/color_space.h"
#include "gaussianize.h"
#include "inverse_table.h"

#include <lichen/gaussianization.h>

#include <optional>
#include <span>

namespace lichen::gaussian {

/// At a larger share, points no longer consist mostly of the pixels' own values.
inline constexpr float kLargestShare = 0.5f;
/// The limit for maps of a set, because surroundings would blur their correlations
/// (docs/decisions/004-transport.md).
inline constexpr float kLargestShareInSet = 0.05f;

struct MapFit {
  float share = exemplar::kUsualShare; ///< of the surroundings, as transportPoints() takes it
  Gaussianized gaussian;
  InverseTable table;
};

struct MapFitOptions {
  gaussian::BorderTreatment borders{};
  gaussian::Precision precision = gaussian::Precision::bits8;
  std::optional<float> share; ///< chosen if absent, in [-0.25, largestShare]
  float largestShare = kLargestShare;
  /// Earlier maps that this one must correlate with.
  std::span<const SettledMap> settled{};
  ProgressPart progress{};
};

/// Gaussianizes a map of 1 to 3 dimensions of colour and fits its inverse table. An absent share is
/// chosen so that the noise has as much detail as the exemplar
/// (docs/decisions/004-transport.md), by at most three fits, on the middle of large maps. Maps
/// too small for a spectrum use the usual share. Colours in one dimension have none.
[[nodiscard]] MapFit fitMap(const MapExemplar& map, const exemplar::ColorSpace& space,
                            const MapFitOptions& options);

/// Returns whether the map is large enough to measure: 64 pixels or more on both sides.
[[nodiscard]] bool hasSpectrum(const MapExemplar& map);

/// Returns the radially averaged power of the noise over the exemplar's in decibels, as a mean over
/// radii from 4 cycles per window upwards. Positive if blending adds detail. Colour is measured by
/// the luminance of its code values, other maps by all channels. `table` comes from
/// fitInverseTable(). Samples 2^20 texels of noise in windows with constant weights. The map must
/// have a spectrum (hasSpectrum()).
[[nodiscard]] double spectrumErrorDb(const MapExemplar& map, const Gaussianized& gaussian,
                                     const InverseTable& table);

} // namespace lichen::gaussian
