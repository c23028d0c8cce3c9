// SPDX-License-Identifier: MIT
// Removes variation that is too slow to fit in an exemplar and makes its noise cloudy.
#pragma once

#include <lichen/bundle.h>
#include <lichen/exemplar.h>
#include <lichen/progress.h>
#include <lichen/result.h>

#include <optional>
#include <span>

namespace lichen {

/// Removes from every map its trend, and the variation slower than `periodPixels`, a period in
/// pixels of the first map, in kFlattenPeriodRange. In maps of other sizes the period is the same
/// share of their size. The trend is a polynomial of degree 4 with the terms that stand out from
/// the material's own variation, since light from one side has no period; the channels of a map of
/// light share it, and if `periodic` its powers are even. In the rest, the filter halves waves of
/// this period and reduces waves of half the period by 1/16. Beyond the borders the rest repeats if
/// `periodic`, else it is mirrored. Base colour and emissive light are divided by their low-passed
/// light, since uneven light is a factor, and clipped at white. From other maps the low-passed
/// values are subtracted; the result stays within their range, except for slopes, which have none.
/// Means do not change, apart from clipping. Opacity is not changed, because its coverage is the
/// material's shape.
/// Needs at least one map, each within the ranges of MapExemplar. After an Error the maps are
/// unspecified. Errors: usage for maps or a period out of range, resources if memory runs out,
/// environment if `progress` stops it. Thread-safe; same values for any number of threads.
/// O(N log N) time.
[[nodiscard]] Result<void> flatten(std::span<MapExemplar> maps, double periodPixels, bool periodic,
                                   const Progress& progress = {});

/// As flatten(), but changes only maps with these targets. The period is in pixels of maps[0],
/// which need not be one of them.
[[nodiscard]] Result<void> flatten(std::span<MapExemplar> maps, double periodPixels, bool periodic,
                                   std::span<const MapTarget> targets,
                                   const Progress& progress = {});

/// Uneven light that was removed from a base colour.
struct RemovedLight {
  double periodPixels = 0.0; ///< flatten() with this period does the same
  double darkest = 1.0;      ///< the least light, as a share of its mean
  double brightest = 1.0;    ///< the most
};

/// Removes uneven light from a base colour, such as a vignette, light from one side or a soft
/// shadow, if its noise would show it as patches: beyond twice what waves of four cycles per side
/// have, waves of one cycle have a deviation of at least a code of 8-bit sRGB, and a fifth of all
/// deviation that is left where the exemplar covers 32 pixels. Flattens with the longest period
/// that leaves no such patches: twice the longer side, which removes little more than the trend, or
/// by halves down to an eighth of it. Only the trend is removed from an image that tiles, if that
/// is three quarters of its patches' deviation, a vignette, and from one whose other slow variation
/// has colours, as the material's own has, if that is a quarter.
/// Returns nothing, and changes nothing, if no patches show, if they have an outline, like a large
/// object and unlike light, or if this does not remove them.
/// Maps, errors and threads: as flatten(). Takes little longer than flatten().
/// Source: docs/decisions/006-light-and-grain.md.
[[nodiscard]] Result<std::optional<RemovedLight>> removeUnevenLight(MapExemplar& map, bool periodic,
                                                                    const Progress& progress = {});

} // namespace lichen
