// SPDX-License-Identifier: MIT
// Bakes exemplars for tiling and blending on a simplex grid [HN18].
#pragma once

#include <lichen/bundle.h>
#include <lichen/exemplar.h>
#include <lichen/progress.h>
#include <lichen/result.h>
#include <lichen/transport.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lichen {

/// Whether maps with Gaussian stored values omit the inverse table.
enum class GaussianOnly {
  detect, ///< test each map (docs/decisions/011-gaussian-only.md)
  yes,    ///< all maps omit it; values that are not Gaussian get another histogram
  no
};

/// How Gaussian values decode to a map's own values.
enum class LookupTable {
  joint,     ///< one table over all dimensions: preserves the exemplar's histogram
  separable, ///< a small table per principal axis of colour; slopes and one-dimensional maps still
             ///< get a joint one
};

struct TilingOptions {
  Periodic periodic = Periodic::detect;
  int bits = 8; ///< 8 or 16 per channel of the tables
  TransportEffort transport = TransportEffort::standard;
  GaussianOnly gaussian = GaussianOnly::detect;
  LookupTable lut = LookupTable::joint;
  Progress progress; ///< empty: no reports
};

/// How close the optimal transport of one map is to the optimum.
struct MapTransportBound {
  MapTarget map{};
  TransportBound bound;
  /// The values have one dimension. Sorting gives the optimal matching, so nothing is left to
  /// prove.
  bool isSorted = false;
  /// Set if the values were moved before matching, to correlate with those of other maps
  /// (docs/decisions/014-correlations-between-maps.md): the cost of matching the original values,
  /// in the units of `bound`. Moved values are nearly Gaussian, so a share of their own cost says
  /// nothing.
  std::optional<double> costOfUnmoved;

  /// The most that a better matching could save, as a share of the cost of matching the values.
  [[nodiscard]] double excess() const {
    return costOfUnmoved ? (bound.cost - bound.lowerBound) / *costOfUnmoved : bound.excess();
  }
};

/// The result of a bake. The maps of `noise` number its tables from 0.
struct TilingBake {
  Noise noise; ///< maps in the order given
  std::vector<Table> tables;
  bool exemplarWasPeriodic = true;
  /// With TransportEffort::exact, how close each transport is to the optimum: one for each map that
  /// varies and has a joint table, and a second one if its borders are blended.
  std::vector<MapTransportBound> transportBounds;
};

/// Gaussianizes each map by optimal transport, makes it periodic, and fits its inverse table with
/// prefiltered slabs. Needs at least one map, each within the ranges of MapExemplar; maps may
/// differ in size. `name` names the noise and, with the target, its tables.
/// Errors: usage for options or maps outside their ranges, or for a map that needs an inverse table
/// when none is allowed; resources if memory runs out; environment if `options.progress` stops it.
/// Thread-safe; runs on all cores; same bytes for any number of threads. O(N log N) in the number
/// of pixels. Source: [HN18] section 4.
[[nodiscard]] Result<TilingBake> bakeTiling(std::string name, std::span<const MapExemplar> maps,
                                            const TilingOptions& options);

} // namespace lichen
