// SPDX-License-Identifier: MIT
// Removes from an exemplar what its noise would show again and again: variation that is too slow to
// fit in it, which makes noise cloudy, and what occurs only once, such as a leaf, a fold or a stain.
#pragma once

#include <lichen/bundle.h>
#include <lichen/exemplar.h>
#include <lichen/progress.h>
#include <lichen/result.h>

#include <array>
#include <optional>
#include <span>
#include <vector>

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

/// What fillOutliers() found, in pixels of the first map.
struct Outliers {
  std::vector<FilledPlace> filled; ///< replaced, in this order
  /// Column, row, width and height of one that is too large to be replaced: more than an eighth of
  /// the map, or larger than any part without another outlier.
  std::optional<std::array<std::uint32_t, 4>> left;
};

/// Finds parts of the first map, a base colour, that visibly stand out from their surroundings,
/// further than all but one other; replaces each in all maps by the part of its size that differs
/// least along its edges. At most four, and none after one that is too large. Maps without one do
/// not change. Nothing for sides under 128 pixels, or longer than four times the other. `periodic`
/// says whether opposite borders fit; they still do afterwards.
/// Needs at least one map, each within the ranges of MapExemplar. After an Error the maps are
/// unspecified. Errors: usage for a map out of range or a first map that is no base colour,
/// resources if memory runs out, environment if `progress` stops it. Thread-safe; same values for
/// any number of threads. O(N) in the number of pixels, plus about 0.1 s.
/// Source: docs/decisions/005-exemplar.md.
[[nodiscard]] Result<Outliers> fillOutliers(std::span<MapExemplar> maps, bool periodic,
                                            const Progress& progress = {});

/// Replaces the places as fillOutliers() does. They count in pixels of the first map; other maps
/// are replaced at the same shares of their sides. A replaced part fades in over a sixth of its
/// shorter side, with preserved variance, and with the mean that the place has along its edges.
/// At borders of the exemplar it fades only if `periodic`.
/// Needs at least one map. After an Error the maps are unspecified. Errors: usage for a map out of
/// range or a place outside the first map, resources. Thread-safe. O(N) per place.
[[nodiscard]] Result<void> fillPlaces(std::span<MapExemplar> maps,
                                      std::span<const FilledPlace> places, bool periodic);

} // namespace lichen
