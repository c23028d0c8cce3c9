// SPDX-License-Identifier: MIT
// Gaussian image and inverse table of one map, fitted to each other.
#pragma once

#include "cross_covariance.h"
#include "exemplar/color_space.h"
#include "gaussianize.h"
#include "inverse_table.h"

#include <lichen/tiling.h>

#include <optional>
#include <span>
#include <vector>

namespace lichen::tiling {

/// Beyond it points are no longer mostly the pixels' own values.
inline constexpr float kLargestShare = 0.5f;
/// Of maps that have others beside them, whose correlations the surroundings would blur
/// (docs/decisions/009-surroundings.md).
inline constexpr float kLargestShareInSet = 0.05f;

/// What going with the maps before it adds to a map's default fit, as a part of it: 0.15 to 0.25 on
/// the photographed sets, 512 x 512.
inline constexpr double kJoiningWork = 0.25;

struct MapFit {
  float share = exemplar::kUsualShare; ///< as transportPoints takes it
  std::vector<Point> points;           ///< of its values; those of a map alone were transported
  Gaussianized gaussian;
  InverseTable table;
  /// As MapTransportBound has it, of the first of the Gaussian image's bounds.
  std::optional<double> costOfUnmoved;
};

struct MapFitOptions {
  bool periodic = true;
  gaussian::Precision precision = gaussian::Precision::bits8;
  TransportEffort transport = TransportEffort::standard;
  std::optional<float> share; ///< chosen where absent, [-0.25, largestShare]
  float largestShare = kLargestShare;
  /// Whose Gaussian images this one is to go with; a fast transport leaves them alone.
  std::span<const SettledMap> settled{};
  ProgressPart progress{};
};

/// What fitting a map of two or three dimensions takes that goes by itself, in units of matching a
/// pixel by the default effort.
struct FitWork {
  double trial = 0.0; ///< of one share, where it is no fit itself; most exemplars need no second
  double fit = 0.0;
};
[[nodiscard]] FitWork fitWork(const MapExemplar& map, bool periodic, TransportEffort effort);

/// Gaussianizes a map of 1 to 3 dimensions of colour and fits its inverse table. A share that is
/// not given is chosen so that the noise has as much detail as the exemplar
/// (docs/decisions/009-surroundings.md): by at most three fits, on the middle of large maps. A fast
/// fit takes the one expected, maps too small for a spectrum the usual one.
/// Colours on a line have none to choose.
[[nodiscard]] MapFit fitMap(const MapExemplar& map, const exemplar::ColorSpace& space,
                            const MapFitOptions& options);

} // namespace lichen::tiling
