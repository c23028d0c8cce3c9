// SPDX-License-Identifier: MIT
// Bakes exemplars for local random-phase noise [LRP14].
#pragma once

#include <lichen/baked_noise.h>
#include <lichen/gaussianization.h>
#include <lichen/regularity.h>
#include <lichen/result.h>
#include <lichen/spectrum_picture.h>

#include <optional>
#include <span>
#include <string>

namespace lichen {

struct LocalRandomPhaseOptions : GaussianizationOptions {
  int cosines = 50; ///< at each vertex; a pixel evaluates three times as many
  /// The share of the power of stored values whose phases are the exemplar's, kStructureRange: 0 is
  /// a random field, and with 1 the exemplar itself is laid in tiles. Absent: as clearly as the
  /// exemplar repeats.
  std::optional<double> structure;
  /// How closely tiles of the structure follow what repeats in the exemplar, kGuideRange: 0 places
  /// them anywhere. Absent: as clearly as it repeats.
  std::optional<double> guide;
  /// The deviation of a smooth random displacement of the structure along each axis [tiles],
  /// kTurbulenceRange.
  double turbulence = 0.0;
  /// In place of the exemplar's, which then gives colours only: the channels of the noise hardly
  /// correlate in space. Excludes a structure.
  std::optional<SpectrumPicture> spectrum;
};
inline constexpr NumberRange kCosinesRange{1.0, double(kMostCosines)};
inline constexpr NumberRange kStructureRange{0.0, 1.0}, kTurbulenceRange{0.0, 1.0};

/// Gaussianizes the maps as bakeTiling() does, and fits cosines to the cross-spectra of all maps
/// together: one phase serves all channels. The noise has the histogram of the exemplar and the
/// spectrum of its Gaussian values; what the phases of the exemplar hold is lost. Maps may differ
/// in size. Needs at least one map, each within the ranges of MapExemplar and with a different
/// target. `name` names the noise and, with the target, its tables. Errors: usage for options or
/// maps outside their ranges; resources if memory runs out; environment if `options.progress` stops
/// it. Thread-safe; runs on all cores; same bytes for any number of threads. O(N log N) in the
/// number of pixels.
[[nodiscard]] Result<MethodBake> bakeLocalRandomPhase(std::string name,
                                                      std::span<const MapExemplar> maps,
                                                      const LocalRandomPhaseOptions& options);

} // namespace lichen
