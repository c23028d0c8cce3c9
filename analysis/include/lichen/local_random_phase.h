// SPDX-License-Identifier: MIT
// Bakes exemplars for local random-phase noise [LRP14].
#pragma once

#include <lichen/bundle.h>
#include <lichen/gaussianization.h>
#include <lichen/result.h>

#include <span>
#include <string>
#include <vector>

namespace lichen {

struct LocalRandomPhaseOptions : GaussianizationOptions {
  int cosines = 50; ///< at each vertex; a pixel evaluates three times as many
};
inline constexpr NumberRange kCosinesRange{1.0, double(kMostCosines)};

/// The result of a bake. The maps of `noise` number its tables from 0.
struct LocalRandomPhaseBake {
  Noise noise; ///< maps in the order given
  std::vector<Table> tables;
  bool exemplarWasPeriodic = true;
};

/// Gaussianizes the maps as bakeTiling() does, and fits cosines to the cross-spectra of all maps
/// together: one phase serves all channels. The noise has the histogram of the exemplar and the
/// spectrum of its Gaussian values; what the phases of the exemplar hold is lost. Maps may differ
/// in size. Needs at least one map, each within the ranges of MapExemplar and with a different
/// target. `name` names the noise and, with the target, its tables. Errors: usage for options or
/// maps outside their ranges; resources if memory runs out; environment if `options.progress` stops
/// it. Thread-safe; runs on all cores; same bytes for any number of threads. O(N log N) in the
/// number of pixels.
[[nodiscard]] Result<LocalRandomPhaseBake>
bakeLocalRandomPhase(std::string name, std::span<const MapExemplar> maps,
                     const LocalRandomPhaseOptions& options);

} // namespace lichen
