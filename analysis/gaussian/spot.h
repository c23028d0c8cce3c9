// SPDX-License-Identifier: MIT
// A kernel that a noise repeats at random positions.
#pragma once

#include <vector>

namespace lichen::gaussian {

/// `width` x `height` values per channel: (x, y, c) is at (c * height + y) * width + x.
struct Spot {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<float> values;
};

} // namespace lichen::gaussian
