// SPDX-License-Identifier: MIT
// Labels (height, width) -> exact Euclidean distances (height, width). Source: [FH12].
#include "distance_transform.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <cstddef>
#include <limits>

namespace lichen::layers {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

/// [FH12] algorithm 1: the lower envelope of parabolas with their lowest points at (i, line[i]).
/// Infinite values have none.
void squaredDistances(std::vector<double>& line) {
  std::vector<int> lowest;   // of the parabolas in the envelope
  std::vector<double> start; // where each begins
  for (int q = 0; q < int(line.size()); ++q) {
    if (std::isinf(line[std::size_t(q)]))
      continue;
    const auto meeting = [&](int p) {
      return ((line[std::size_t(q)] + double(q) * q) - (line[std::size_t(p)] + double(p) * p)) /
             (2.0 * (q - p));
    };
    while (!lowest.empty() && meeting(lowest.back()) <= start.back()) {
      lowest.pop_back();
      start.pop_back();
    }
    start.push_back(lowest.empty() ? -double(kFar) : meeting(lowest.back()));
    lowest.push_back(q);
  }
  if (lowest.empty())
    return;
  std::vector<double> distances(line.size());
  std::size_t k = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    while (k + 1 < start.size() && start[k + 1] < double(i))
      ++k;
    const double offset = double(i) - lowest[k];
    distances[i] = offset * offset + line[std::size_t(lowest[k])];
  }
  line = std::move(distances);
}

} // namespace

std::vector<float> distanceToOthers(const LabelImage& labels, int label) {
  const auto width = std::size_t(labels.width), height = std::size_t(labels.height);
  std::vector<float> squares(width * height);
  tbb::parallel_for(std::size_t(0), width, [&](std::size_t x) {
    std::vector<double> line(height);
    for (std::size_t y = 0; y < height; ++y)
      line[y] = labels.labels[y * width + x] == label ? double(kFar) : 0.0;
    squaredDistances(line);
    for (std::size_t y = 0; y < height; ++y)
      squares[y * width + x] = float(line[y]);
  });
  tbb::parallel_for(std::size_t(0), height, [&](std::size_t y) {
    std::vector<double> line(&squares[y * width], &squares[y * width] + width);
    squaredDistances(line);
    for (std::size_t x = 0; x < width; ++x)
      squares[y * width + x] = float(std::sqrt(line[x]));
  });
  return squares;
}

} // namespace lichen::layers
