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

/// Whether maps whose stored values are Gaussian do without an inverse table.
enum class GaussianOnly {
  detect, ///< by a test of each map (docs/decisions/011-gaussian-only.md)
  yes,    ///< all maps: other values than Gaussian ones get another histogram
  no
};

/// How a map's Gaussian values become its own.
enum class LookupTable {
  joint,     ///< one table over all dimensions: the exemplar's histogram
  separable, ///< a table for each principal axis of colour, small; slopes and maps of one dimension
             ///< have a joint one
};

struct TilingOptions {
  Periodic periodic = Periodic::detect;
  int bits = 8; ///< 8 or 16 per channel of the tables
  TransportEffort transport = TransportEffort::standard;
  GaussianOnly gaussian = GaussianOnly::detect;
  LookupTable lut = LookupTable::joint;
  Progress progress; ///< empty: nobody watches
};

/// How near the optimum a transport of one map is.
struct MapTransportBound {
  MapTarget map{};
  TransportBound bound;
  /// Values of one dimension, whose sorted matching is the optimum: nothing is left to prove.
  bool isSorted = false;
  /// Where the values were moved to go with those of other maps before they were matched
  /// (docs/decisions/014-correlations-between-maps.md): what matching them as they are costs, in
  /// the units of `bound`. Those moved are nearly Gaussian, and a share of their own cost would say
  /// nothing.
  std::optional<double> costOfUnmoved;

  /// What a better matching might save at most, as a share of what matching the values costs.
  [[nodiscard]] double excess() const {
    return costOfUnmoved ? (bound.cost - bound.lowerBound) / *costOfUnmoved : bound.excess();
  }
};

/// What a bake made: tables numbered from 0 in the maps of `noise`.
struct TilingBake {
  Noise noise; ///< its maps in the order given
  std::vector<Table> tables;
  bool exemplarWasPeriodic = true;
  /// With TransportEffort::exact, how near the optimum each transport is: one of each map that has
  /// a joint table and varies, and one more of each of those whose borders are blended.
  std::vector<MapTransportBound> transportBounds;
};

/// Gaussianizes each map by optimal transport, makes it periodic, and fits its inverse table with
/// prefiltered slabs. At least one map, each within the ranges above; maps may differ in size.
/// `name` names the noise and, with the target, its tables.
/// Errors: usage for options or maps outside their ranges, or a map that cannot do without a table,
/// resources when memory does not suffice, environment when `options.progress` stops it.
/// Thread-safe; runs on all cores, and the same bytes for any number of threads. O(N log N) in the
/// number of pixels. Source: [HN18] section 4.
[[nodiscard]] Result<TilingBake> bakeTiling(std::string name, std::span<const MapExemplar> maps,
                                            const TilingOptions& options);

} // namespace lichen
