// SPDX-License-Identifier: MIT
// Whether an exemplar tiles.
#pragma once

#include <lichen/exemplar.h>

#include <algorithm>
#include <functional>

namespace lichen::exemplar {

/// How much more opposite borders differ than neighbours inside do: the difference across the seam,
/// averaged over runs of four pixels along it and then by absolute value, over the 90th percentile
/// of the same mean between interior neighbours. Up to about 1 where there is no seam. 0 across a
/// side under 8 pixels, for want of an interior, and across borders of equal values; infinite when
/// only the seam has differences.
struct SeamStrength {
  double betweenColumns = 0.0; ///< the last and the first
  double betweenRows = 0.0;
};
[[nodiscard]] SeamStrength seamStrength(const MapExemplar& map);

/// Whether no seam is stronger than 1.25 (docs/decisions/006-seam-detection.md).
[[nodiscard]] bool isPeriodic(const MapExemplar& map);

/// Whether a bake keeps the borders of `maps`: as told, or as all of them are periodic. Each is
/// what `mapOf` makes of an element.
template <class Maps, class MapOf>
[[nodiscard]] bool keepsBorders(const Maps& maps, Periodic told, const MapOf& mapOf) {
  return told == Periodic::yes ||
         (told == Periodic::detect && std::all_of(maps.begin(), maps.end(), [&](const auto& each) {
            return isPeriodic(std::invoke(mapOf, each));
          }));
}

} // namespace lichen::exemplar
