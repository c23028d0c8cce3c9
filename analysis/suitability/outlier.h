// SPDX-License-Identifier: MIT
// Finds what an exemplar shows only once, such as a leaf, a fold or a stain.
#pragma once

#include <lichen/exemplar.h>

#include <optional>
#include <vector>

namespace lichen::suitability {

/// Part of an exemplar, in pixels.
struct Part {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

/// The map at most 256 pixels long, and what stands out in it.
struct Outlier {
  MapExemplar reduced;
  Part part;                 ///< of the reduced map, with a margin of half the scale
  std::vector<bool> unusual; ///< reduced pixels that differ nearly as much as the third place
};

/// The part of a colour map that stands out most from its surroundings, if nothing like it occurs
/// a third time. At four scales, from a 64th to a 16th of the longer side, every place is compared
/// with its surroundings by their difference in colour, in deviations of the differences elsewhere.
/// A place is an outlier if at some scale its difference is visible (kVisibleOutlier) and more than
/// kOutlier times the third strongest place's. Nothing for sides under 128 pixels, or longer than
/// four times the other. Throws std::bad_alloc.
[[nodiscard]] std::optional<Outlier> outlierOf(const MapExemplar& map);

} // namespace lichen::suitability
