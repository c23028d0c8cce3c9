// SPDX-License-Identifier: MIT
// A picture -> the exemplar of its colours.
#pragma once

#include <lichen/exemplar.h>
#include <lichen/image.h>

namespace lichen::test {

/// Returns the image as a base-colour map (RGB).
[[nodiscard]] inline MapExemplar baseColor(const SrgbImage& image) {
  MapExemplar map;
  map.channels = {MapChannel::red, MapChannel::green, MapChannel::blue};
  map.width = image.width;
  map.height = image.height;
  map.values = image.values;
  return map;
}

} // namespace lichen::test
