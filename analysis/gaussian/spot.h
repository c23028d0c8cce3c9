// SPDX-License-Identifier: MIT
// A kernel that a noise repeats at random places.
#pragma once

#include <vector>

namespace lichen::gaussian {

/// `width` x `height` values of each channel: (x, y, c) at (c * height + y) * width + x.
struct Spot {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<float> values;
};

} // namespace lichen::gaussian
