// SPDX-License-Identifier: MIT
// Tests whether an exemplar tiles.
#pragma once

#include <lichen/exemplar.h>

#include <algorithm>
#include <functional>

namespace lichen::exemplar {

/// How much more opposite borders differ than interior neighbours do: a ratio. The numerator is the
/// difference across the seam, averaged over runs of four pixels along it, then the mean of its
/// absolute values. The denominator is the 90th percentile of the same measure between interior
/// neighbours.
/// The ratio is at most about 1 where there is no seam. It is 0 across a side under 8 pixels, which
/// has too small an interior, and across borders of equal values. It is infinite when only the seam
/// has differences.
struct SeamStrength {
  double betweenColumns = 0.0; ///< between the last and the first
  double betweenRows = 0.0;
};
[[nodiscard]] SeamStrength seamStrength(const MapExemplar& map);

/// Returns whether no seam is stronger than 1.25 (docs/decisions/006-seam-detection.md).
[[nodiscard]] bool isPeriodic(const MapExemplar& map);

/// Returns whether a bake preserves the borders of `maps`: if `told` is yes, or if it is detect and
/// all maps are periodic. `mapOf` returns the map of an element.
template <class Maps, class MapOf>
[[nodiscard]] bool keepsBorders(const Maps& maps, Periodic told, const MapOf& mapOf) {
  return told == Periodic::yes ||
         (told == Periodic::detect && std::all_of(maps.begin(), maps.end(), [&](const auto& each) {
            return isPeriodic(std::invoke(mapOf, each));
          }));
}

} // namespace lichen::exemplar
