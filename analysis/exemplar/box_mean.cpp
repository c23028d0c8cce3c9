// SPDX-License-Identifier: MIT
// Plane (height, width) -> plane of means. Rows, then columns, each by a running sum.
#include "box_mean.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>

namespace lichen::exemplar {
namespace {

/// Means along lines of `count` values; line k starts at k * `lineStep`.
void meansAlongLines(std::span<const float> from, std::span<float> to, int lines,
                     std::ptrdiff_t lineStep, int count, std::ptrdiff_t step, int radius) {
  tbb::parallel_for(0, lines, [&](int line) {
    const std::ptrdiff_t start = line * lineStep;
    const auto at = [&](int i) { return double(from[std::size_t(start + i * step)]); };
    double sum = 0.0;
    for (int i = 0; i < std::min(radius, count); ++i)
      sum += at(i);
    for (int i = 0; i < count; ++i) {
      if (i + radius < count)
        sum += at(i + radius);
      if (i - radius > 0)
        sum -= at(i - radius - 1);
      const int pixels = std::min(count - 1, i + radius) - std::max(0, i - radius) + 1;
      to[std::size_t(start + i * step)] = float(sum / pixels);
    }
  });
}

} // namespace

std::vector<float> boxMean(std::span<const float> plane, int width, int height, int radius) {
  std::vector<float> rows(plane.size()), means(plane.size());
  meansAlongLines(plane, rows, height, width, width, 1, radius);
  meansAlongLines(rows, means, width, 1, height, width, radius);
  return means;
}

} // namespace lichen::exemplar
