// SPDX-License-Identifier: MIT
// Values (height, width, channels) -> OKLab (height, width, 3). Source: [O20].
#include "oklab.h"

#include "exemplar/value_encoding.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace lichen::layers {

Lab oklab(float red, float green, float blue) {
  // [O20], "converting from linear sRGB to OKLab".
  const float l = std::cbrt(0.4122214708f * red + 0.5363325363f * green + 0.0514459929f * blue);
  const float m = std::cbrt(0.2119034982f * red + 0.6806995451f * green + 0.1073969566f * blue);
  const float s = std::cbrt(0.0883024619f * red + 0.2817188376f * green + 0.6299787005f * blue);
  return {0.2104542553f * l + 0.7936177850f * m - 0.0040720468f * s,
          1.9779984951f * l - 2.4285922050f * m + 0.4505937099f * s,
          0.0259040371f * l + 0.7827717662f * m - 0.8086757660f * s};
}

std::vector<Lab> oklabOf(const MapExemplar& map) {
  const std::size_t channels = map.channels.size();
  std::vector<Lab> colors(map.values.size() / channels);
  tbb::parallel_for(std::size_t(0), colors.size(), [&](std::size_t i) {
    std::array<float, 3> light{};
    for (std::size_t c = 0; c < light.size(); ++c)
      light[c] =
          exemplar::decoded(map.values[channels * i + std::min(c, channels - 1)], map.encoding);
    colors[i] = oklab(light[0], light[1], light[2]);
  });
  return colors;
}

} // namespace lichen::layers
