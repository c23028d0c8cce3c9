// SPDX-License-Identifier: MIT
// A level -> the next coarser one, by the overlap of their texels.
#include "area_average.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

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

} // namespace lichen::exemplar
