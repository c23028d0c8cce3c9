// SPDX-License-Identifier: MIT
// Removes variation that is too slow to fit in an exemplar and makes its noise cloudy.
#pragma once

#include <lichen/bundle.h>
#include <lichen/exemplar.h>
#include <lichen/progress.h>
#include <lichen/result.h>

#include <optional>
#include <span>
#include <vector>

namespace lichen {

/// Removes from every map the variation slower than `periodPixels`, a period in pixels of the first
/// map, in kFlattenPeriodRange. In maps of other sizes the period is the same share of their size.
/// The filter halves waves of this period and reduces waves of half the period by 1/16. Beyond the
/// borders the image repeats if `periodic`, else it is mirrored. Base colour and emissive light are
/// divided by their low-passed light, since uneven light is a factor, and clipped at white. From
/// other maps the low-passed values are subtracted; the result stays within their range, except
/// for slopes, which have none. Means do not change, apart from clipping. Opacity is not changed,
/// because its coverage is the material's shape.
/// Needs at least one map, each within the ranges of MapExemplar. After an Error the maps are
/// unspecified. Errors: usage for maps or a period out of range, resources if memory runs out,
/// environment if `progress` stops it. Thread-safe; same values for any number of threads.
/// O(N log N) time; 64 bytes per pixel.
[[nodiscard]] Result<void> flatten(std::span<MapExemplar> maps, double periodPixels, bool periodic,
                                   const Progress& progress = {});

/// As flatten(), but changes only maps with these targets. The period is in pixels of maps[0],
/// which need not be one of them.
[[nodiscard]] Result<void> flatten(std::span<MapExemplar> maps, double periodPixels, bool periodic,
                                   std::span<const MapTarget> targets,
                                   const Progress& progress = {});

/// What flattenAutomatically() did and why.
struct FlatteningChoice {
  enum class Reason {
    flattened,  ///< flattening removed the risks of the first map
    noRisk,     ///< the first map had neither risk
    object,     ///< the slow variation is an object with an outline, not light
    unresolved, ///< not even the shortest period removed the risks
  };

  Reason reason = Reason::noRisk;
  std::optional<double> periodPixels; ///< of the first map; set only for Reason::flattened
  std::vector<MapTarget> flattened;   ///< the maps that were changed, in order
};

/// If the first map has a mild or severe cloudiness or low-frequency risk, flattens with the
/// longest period that leaves it neither, and no patches that are visible in the noise: beyond what
/// waves of four cycles per side have, those of one cycle have less than 1 % of the blended
/// variance. The shortest period may leave patches, but no risk. Periods are tried in steps of half
/// an octave, from twice the longer side of the first map to an eighth of it. The other maps are
/// flattened with the same share of their sides, but only if they have one of the two risks
/// themselves: uneven light in a photograph affects its colours, while normals, heights and other
/// data have none. Nothing changes unless the reason is Reason::flattened. Maps, errors and
/// threads: as flatten(). Takes about five times as long as flatten() and assessSuitability() of
/// the first map, and once as long for the others. Source: docs/decisions/013-suitability.md.
[[nodiscard]] Result<FlatteningChoice>
flattenAutomatically(std::span<MapExemplar> maps, bool periodic, const Progress& progress = {});

} // namespace lichen
