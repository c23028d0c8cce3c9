// SPDX-License-Identifier: MIT
// The mip levels of an image, each of which averages the next finer one over areas.
#pragma once

#include <vector>

namespace lichen::exemplar {

/// width * height * channels interleaved values.
struct ImageLevel {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<float> values;
};

/// The level with half as many columns and rows, rounded down but at least 1. Odd sides lose no
/// row: each texel averages the area that it covers. Throws std::bad_alloc.
[[nodiscard]] ImageLevel areaAverage(const ImageLevel& source);

} // namespace lichen::exemplar
