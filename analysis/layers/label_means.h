// SPDX-License-Identifier: MIT
// Labels at the size of a map, and the colours under them.
#pragma once

#include "oklab.h"

#include <lichen/layers.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lichen::layers {

/// The pixel, among `from` along a side, at the centre of pixel i of `to`.
[[nodiscard]] constexpr std::size_t nearestPixel(int i, int to, int from) {
  return std::size_t((2 * std::int64_t(i) + 1) * from / (2 * std::int64_t(to)));
}

/// The labels nearest to the centres of width x height pixels of the tile. Throws std::bad_alloc.
[[nodiscard]] LabelImage resizedLabels(const LabelImage& labels, int width, int height);

/// The mean colour of each label and its pixels. `labels` has the size of the map that `colors` are
/// of. Throws std::bad_alloc.
struct LabelMean {
  Lab color{};
  double pixels = 0.0;
};
[[nodiscard]] std::vector<LabelMean> labelMeans(const std::vector<Lab>& colors,
                                                const LabelImage& labels);

} // namespace lichen::layers
