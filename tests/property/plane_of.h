// SPDX-License-Identifier: MIT
// A map of one channel from a function of the pixel.
#pragma once

#include <lichen/exemplar.h>

namespace lichen::test {

/// Linear values `valueAt(x, y)`.
[[nodiscard]] MapExemplar planeOf(int width, int height, const auto& valueAt) {
  MapExemplar map;
  map.channels = {MapChannel::red};
  map.encoding = ValueEncoding::linear;
  map.width = width;
  map.height = height;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      map.values.push_back(float(valueAt(x, y)));
  return map;
}

} // namespace lichen::test
