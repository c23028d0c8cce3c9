// SPDX-License-Identifier: MIT
// Bakes exemplars for tiling and blending on a simplex grid [HN18].
#pragma once

#include <lichen/bundle.h>
#include <lichen/exemplar.h>
#include <lichen/progress.h>
#include <lichen/result.h>

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

/// How close to the optimum the optimal transport gets: its largest cost above the optimum,
/// measured on the exemplars of docs/decisions/008-multiscale-transport.md.
enum class TransportEffort {
  fast,     ///< 0.4 %; for previews
  standard, ///< 0.1 %; for production
};

struct TilingOptions {
  Periodic periodic = Periodic::detect;
  int bits = 8; ///< 8 or 16 per channel of the tables
  TransportEffort transport = TransportEffort::standard;
  GaussianOnly gaussian = GaussianOnly::detect;
  Progress progress; ///< empty: no reports
};

/// The result of a bake. The maps of `noise` number its tables from 0.
struct TilingBake {
  Noise noise; ///< maps in the order given
  std::vector<Table> tables;
  bool exemplarWasPeriodic = true;
};

/// Gaussianizes each map by optimal transport, makes it periodic, and fits its inverse table with
/// prefiltered mip levels. Needs at least one map, each within the ranges of MapExemplar; maps may
/// differ in size. `name` names the noise and, with the target, its tables.
/// Errors: usage for options or maps outside their ranges, or for a map that needs an inverse table
/// when none is allowed; resources if memory runs out; environment if `options.progress` stops it.
/// Thread-safe; runs on all cores; same bytes for any number of threads. O(N log N) in the number
/// of pixels. Source: [HN18] section 4.
[[nodiscard]] Result<TilingBake> bakeTiling(std::string name, std::span<const MapExemplar> maps,
                                            const TilingOptions& options);

} // namespace lichen
