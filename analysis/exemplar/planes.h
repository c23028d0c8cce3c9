// SPDX-License-Identifier: MIT
// Images without encoding: mip levels by area averages, means over squares, quantiles, and a map as
// one small grey plane, for measures of what shows from some distance.
#pragma once

#include <lichen/exemplar.h>

#include <algorithm>
#include <cstddef>
#include <span>
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

/// The map, halved until neither side is longer than `mostSide`. Throws std::bad_alloc.
[[nodiscard]] ImageLevel reducedImage(const MapExemplar& map, int mostSide);

/// The quantile of the values at `share`, in [0, 1]. Precondition: there is a value.
template <class Value>
[[nodiscard]] Value quantile(std::vector<Value> values, double share) {
  const auto place = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/// The mean of each pixel's square of 2 `radius` + 1 pixels per side, as far as it lies in the
/// plane. Throws std::bad_alloc. O(N) for any radius.
[[nodiscard]] std::vector<float> boxMean(std::span<const float> plane, int width, int height,
                                         int radius);

/// One channel of an image: width x height values, row 0 at the top.
struct Plane {
  int width = 0, height = 0;
  std::vector<float> values;

  [[nodiscard]] std::size_t index(int x, int y) const {
    return std::size_t(y) * std::size_t(width) + std::size_t(x);
  }
  [[nodiscard]] float at(int x, int y) const { return values[index(x, y)]; }
};

/// Averages squares of pixels, and all channels, less the mean of all, so that the shorter side has
/// `side` to 2 * side - 1 values, or as many as the map has pixels if those are fewer. Throws
/// std::bad_alloc.
[[nodiscard]] Plane reducedPlane(const MapExemplar& map, int side);

} // namespace lichen::exemplar
