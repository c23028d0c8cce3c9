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

/// Finds parts of the first map, a base colour, that stand out from their surroundings and have
/// nothing like them, or only one other; replaces each in all maps by the part of its size that
/// differs least along its edges. At most four. Maps without one do not change. Nothing for sides
/// under 128 pixels.
/// Needs at least one map, each within the ranges of MapExemplar. After an Error the maps are
/// unspecified. Errors: usage for a map out of range or a first map that is no base colour,
/// resources if memory runs out, environment if `progress` stops it. Thread-safe; same values for
/// any number of threads. O(N) in the number of pixels, plus about 0.1 s.
/// Source: docs/decisions/034-outliers.md.
[[nodiscard]] Result<Outliers> fillOutliers(std::span<MapExemplar> maps,
                                            const Progress& progress = {});

/// Replaces the places as fillOutliers() does. They count in pixels of the first map; other maps
/// are replaced at the same shares of their sides. A replaced part fades in over a sixth of its
/// shorter side, with preserved variance, and with the mean that the place has along its edges.
/// Errors: usage for a map out of range or a place outside the first map; resources.
[[nodiscard]] Result<void> fillPlaces(std::span<MapExemplar> maps,
                                      std::span<const FilledPlace> places);

} // namespace lichen
