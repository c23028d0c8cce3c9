// SPDX-License-Identifier: MIT
// Labels (height, width) and colours (height, width, 3) -> means (count, 3).
#include "label_means.h"

#include <array>
#include <cstddef>

namespace lichen::layers {

LabelImage resizedLabels(const LabelImage& labels, int width, int height) {
  if (width == labels.width && height == labels.height)
    return labels;
  LabelImage resized{width, height, labels.count, {}};
  resized.labels.reserve(std::size_t(width) * std::size_t(height));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      resized.labels.push_back(
          labels.labels[nearestPixel(y, height, labels.height) * std::size_t(labels.width) +
                        nearestPixel(x, width, labels.width)]);
  return resized;
}

std::vector<LabelMean> labelMeans(const std::vector<Lab>& colors, const LabelImage& labels) {
  std::vector<std::array<double, 4>> sums(std::size_t(labels.count), std::array<double, 4>{});
  for (std::size_t i = 0; i < colors.size(); ++i) {
    std::array<double, 4>& sum = sums[labels.labels[i]];
    for (std::size_t c = 0; c < 3; ++c)
      sum[c] += double(colors[i][c]);
    sum[3] += 1.0;
  }
  std::vector<LabelMean> means;
  for (const std::array<double, 4>& sum : sums) {
    LabelMean mean;
    mean.pixels = sum[3];
    for (std::size_t c = 0; c < 3; ++c)
      mean.color[c] = sum[3] > 0.0 ? float(sum[c] / sum[3]) : 0.0f;
    means.push_back(mean);
  }
  return means;
}

} // namespace lichen::layers
