// SPDX-License-Identifier: MIT
// Replaces what an exemplar shows only once, such as a leaf, a fold or a stain: noise would show it
// again and again.
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
