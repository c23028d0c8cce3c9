// SPDX-License-Identifier: MIT
// Measures visible cloudiness with the tables of a bake.
#pragma once

#include "base_color.h"

#include <lichen/tiling.h>

#include <vector>

namespace lichen::test {

[[nodiscard]] double mean(const std::vector<double>& values);
[[nodiscard]] double variance(const std::vector<double>& values);

/// Blends three equally weighted taps at each of `samples` random offsets, and returns the relative
/// standard deviation of the variance of the decoded luminance over the whole tile. The map must
/// tile and have three colour dimensions.
[[nodiscard]] double measuredCloudiness(const MapExemplar& map, int samples);

} // namespace lichen::test
