// SPDX-License-Identifier: MIT
// A level -> the next coarser one, by the overlap of their texels.
#include "planes.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace lichen::exemplar {
namespace {

/// The share of each source texel in the average for destination texel i: the overlap when a side
/// of `source` texels is reduced to `destination`.
struct Footprint {
  int first = 0;
  std::array<double, 4> weight{}; ///< sums to 1; a ratio of at most 3 touches at most 4 texels
  int count = 0;
};

Footprint footprintOf(int i, int source, int destination) {
  const double ratio = double(source) / destination;
  const double begin = i * ratio;
  const double end = (i + 1) * ratio;
  Footprint footprint;
  footprint.first = int(begin);
  for (int k = footprint.first; k < source && double(k) < end - 1e-9; ++k) {
    const double overlap = std::min(end, k + 1.0) - std::max(begin, double(k));
    footprint.weight[std::size_t(footprint.count++)] = overlap / ratio;
  }
  return footprint;
}

} // namespace

ImageLevel areaAverage(const ImageLevel& source) {
  ImageLevel result{
      std::max(1, source.width / 2), std::max(1, source.height / 2), source.channels, {}};
  result.values.resize(std::size_t(result.width) * std::size_t(result.height) *
                       std::size_t(result.channels));
  tbb::parallel_for(0, result.height, [&](int y) {
    const Footprint rows = footprintOf(y, source.height, result.height);
    for (int x = 0; x < result.width; ++x) {
      const Footprint columns = footprintOf(x, source.width, result.width);
      float* out = &result.values[(std::size_t(y) * std::size_t(result.width) + std::size_t(x)) *
                                  std::size_t(result.channels)];
      for (int c = 0; c < result.channels; ++c) {
        double sum = 0.0;
        for (int r = 0; r < rows.count; ++r)
          for (int k = 0; k < columns.count; ++k)
            sum += rows.weight[std::size_t(r)] * columns.weight[std::size_t(k)] *
                   double(source.values[(std::size_t(rows.first + r) * std::size_t(source.width) +
                                         std::size_t(columns.first + k)) *
                                            std::size_t(source.channels) +
                                        std::size_t(c)]);
        out[c] = float(sum);
      }
    }
  });
  return result;
}

ImageLevel reducedImage(const MapExemplar& map, int mostSide) {
  ImageLevel level{map.width, map.height, int(map.channels.size()), map.values};
  while (std::max(level.width, level.height) > mostSide)
    level = areaAverage(level);
  return level;
}

// Plane (height, width) -> plane of means. Rows, then columns, each by a running sum.
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

// Map -> small grey plane.

Plane reducedPlane(const MapExemplar& map, int side) {
  const int square = std::max(1, std::min(map.width, map.height) / side);
  const auto channels = int(map.channels.size());
  Plane plane{map.width / square, map.height / square, {}};
  plane.values.reserve(std::size_t(plane.width) * std::size_t(plane.height));
  double sum = 0.0;
  for (int y = 0; y < plane.height; ++y)
    for (int x = 0; x < plane.width; ++x) {
      float total = 0.0f;
      for (int dy = 0; dy < square; ++dy) {
        const std::size_t row = std::size_t(y * square + dy) * std::size_t(map.width);
        const auto* begin = &map.values[(row + std::size_t(x * square)) * std::size_t(channels)];
        for (int k = 0; k < square * channels; ++k)
          total += begin[k];
      }
      plane.values.push_back(total / float(square * square * channels));
      sum += double(plane.values.back());
    }
  const auto mean = float(sum / double(plane.values.size()));
  for (float& value : plane.values)
    value -= mean;
  return plane;
}

} // namespace lichen::exemplar
