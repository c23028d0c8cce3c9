// SPDX-License-Identifier: MIT
// Straight edges along rows and columns that a result has and its exemplar does not.
//
// Two images -> one number.
#include "boundary.h"

#include <lichen/quality.h>
#include <lichen/spectrum.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace lichen {
namespace {

constexpr int kRun = 48;                // pixels along the seam
constexpr double kPercentile = 0.999;   // of the averages
constexpr std::size_t kSteps = 1 << 16; // bins of the histogram of averages
/// One 8-bit code step in one pixel of a run. Smaller averages are no edge.
constexpr double kSmallestAverage = 1.0 / (255.0 * kRun);

/// A histogram of the absolute averages of runs.
struct Histogram {
  double range = 0.0;
  std::vector<std::uint64_t> counts = std::vector<std::uint64_t>(kSteps, 0);
};

/// Adds all runs of differences between neighbouring lines. A line has `length` values at `stride`;
/// lines are `lineStride` apart.
void addRuns(const std::vector<float>& plane, int lines, std::size_t lineStride, int length,
             std::size_t stride, Histogram& histogram) {
  const double toStep = double(kSteps) / (histogram.range * kRun);
  for (int line = 0; line + 1 < lines; ++line) {
    const float* first = plane.data() + std::size_t(line) * lineStride;
    const float* second = first + lineStride;
    const auto difference = [&](int k) {
      const std::size_t at = std::size_t(k) * stride;
      return double(second[at]) - double(first[at]);
    };
    double sum = 0.0;
    for (int k = 0; k < length; ++k) {
      sum += difference(k);
      if (k + 1 < kRun)
        continue;
      const auto step = std::size_t(std::abs(sum) * toStep);
      ++histogram.counts[std::min(step, kSteps - 1)];
      sum -= difference(k + 1 - kRun);
    }
  }
}

double edgePercentile(const SrgbImage& image) {
  const std::vector<float> plane = luminancePlane(image);
  const auto [low, high] = std::minmax_element(plane.begin(), plane.end());
  Histogram histogram;
  histogram.range = double(*high) - double(*low);
  if (histogram.range <= 0.0)
    return kSmallestAverage;
  const auto width = std::size_t(image.width);
  addRuns(plane, image.width, 1, image.height, width, histogram);
  addRuns(plane, image.height, width, image.width, 1, histogram);

  std::uint64_t total = 0;
  for (const std::uint64_t count : histogram.counts)
    total += count;
  std::uint64_t below = 0;
  std::size_t step = 0;
  while (double(below + histogram.counts[step]) < kPercentile * double(total))
    below += histogram.counts[step++];
  const double average = (double(step) + 0.5) * histogram.range / double(kSteps);
  return std::max(average, kSmallestAverage);
}

} // namespace

Result<double> seamVisibility(const SrgbImage& exemplar, const SrgbImage& result) {
  return withinMemory(exhausted, [&]() -> Result<double> {
    if (auto error = refusal(exemplar, result, kRun + 1))
      return *error;
    return edgePercentile(result) / edgePercentile(exemplar);
  });
}

} // namespace lichen
