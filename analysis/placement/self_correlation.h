// SPDX-License-Identifier: MIT
// How highly a picture correlates with itself, moved without wrapping around.
#pragma once

#include "exemplar/area_average.h"

#include <cstddef>
#include <vector>

namespace lichen::placement {

/// How highly a picture correlates with itself, moved by (x, y), less than its sides in either
/// direction.
struct SelfCorrelation {
  int width = 0, height = 0; ///< twice the picture's
  std::vector<float> values; ///< [y * width + x], negative x and y from the end

  [[nodiscard]] float at(int x, int y) const {
    x = x < 0 ? x + width : x;
    y = y < 0 ? y + height : y;
    return values[std::size_t(y) * std::size_t(width) + std::size_t(x)];
  }
};

/// The products of all pairs of values, over the root of the energies of both parts that overlap; 0
/// where hardly anything overlaps. For several channels, the sum. O(N log N) in the pixels. Throws
/// std::bad_alloc.
[[nodiscard]] SelfCorrelation selfCorrelation(const exemplar::ImageLevel& image);

} // namespace lichen::placement
