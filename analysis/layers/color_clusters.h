// SPDX-License-Identifier: MIT
// Clusters of colours.
#pragma once

#include "oklab.h"

#include <span>
#include <vector>

namespace lichen::layers {

[[nodiscard]] float squaredDistance(const Lab& a, const Lab& b);

/// The nearest of these colours.
[[nodiscard]] std::size_t nearestOf(std::span<const Lab> centers, const Lab& color);

/// `count` colours with the least sum of squared distances that several starts find, by ascending
/// lightness; fewer if the colours have fewer different values. Deterministic. Throws
/// std::bad_alloc. O(N count).
[[nodiscard]] std::vector<Lab> clusterCenters(std::span<const Lab> colors, std::size_t count);

} // namespace lichen::layers
