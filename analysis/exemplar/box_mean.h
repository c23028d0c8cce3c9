// SPDX-License-Identifier: MIT
// Means over squares of pixels.
#pragma once

#include <span>
#include <vector>

namespace lichen::exemplar {

/// The mean of each pixel's square of 2 `radius` + 1 pixels per side, as far as it lies in the
/// plane. Throws std::bad_alloc. O(N) for any radius.
[[nodiscard]] std::vector<float> boxMean(std::span<const float> plane, int width, int height,
                                         int radius);

} // namespace lichen::exemplar
