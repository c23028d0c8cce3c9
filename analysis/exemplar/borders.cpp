// SPDX-License-Identifier: MIT
// Exemplar (width * height values per channel) -> the strength of the seams between its borders.
#include "borders.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lichen::exemplar {
namespace {

constexpr int kFewestForDetection = 8;

/// Measured on photographs and their crops: docs/decisions/006-seam-detection.md.
constexpr double kSeamThreshold = 1.25;
constexpr double kPercentile = 0.9;
constexpr int kRunPixels = 4;

/// Returns, for every k, how much lines k and k + 1 (wrapping) differ: differences averaged over
/// runs of kRunPixels along the line, then their absolute values. Grain averages out in a run; a
/// step along the seam that the eye follows does not. A line is a column if `alongX`.
std::vector<double> lineDifferences(const MapExemplar& map, bool alongX) {
  const int lines = alongX ? map.width : map.height;
  const int length = alongX ? map.height : map.width;
  const int run = std::min(kRunPixels, length);
  const std::size_t channels = map.channels.size();
  const std::size_t lineStride = channels * (alongX ? 1u : std::size_t(map.width));
  const std::size_t stride = channels * (alongX ? std::size_t(map.width) : 1u);
  std::vector<double> sums(std::size_t(lines), 0.0);
  for (int line = 0; line < lines; ++line)
    for (std::size_t c = 0; c < channels; ++c) {
      const float* here = &map.values[std::size_t(line) * lineStride + c];
      const float* next = &map.values[std::size_t((line + 1) % lines) * lineStride + c];
      const auto difference = [&](int k) {
        return double(next[std::size_t(k) * stride]) - double(here[std::size_t(k) * stride]);
      };
      double sum = 0.0;
      for (int k = 0; k < length; ++k) {
        sum += difference(k);
        if (k + 1 < run)
          continue;
        sums[std::size_t(line)] += std::abs(sum);
        sum -= difference(k + 1 - run);
      }
    }
  return sums;
}

double strengthOf(std::vector<double> differences) {
  const double seam = differences.back();
  differences.pop_back();
  const auto place = differences.begin() + std::ptrdiff_t(kPercentile * double(differences.size()));
  std::nth_element(differences.begin(), place, differences.end());
  if (*place > 0.0)
    return seam / *place;
  return seam > 0.0 ? std::numeric_limits<double>::infinity() : 0.0;
}

} // namespace

SeamStrength seamStrength(const MapExemplar& map) {
  SeamStrength strength;
  if (map.width >= kFewestForDetection)
    strength.betweenColumns = strengthOf(lineDifferences(map, true));
  if (map.height >= kFewestForDetection)
    strength.betweenRows = strengthOf(lineDifferences(map, false));
  return strength;
}

bool isPeriodic(const MapExemplar& map) {
  const SeamStrength strength = seamStrength(map);
  return std::max(strength.betweenColumns, strength.betweenRows) <= kSeamThreshold;
}

} // namespace lichen::exemplar

bool lichen::bordersFit(std::span<const MapExemplar> maps, Periodic periodic) {
  return exemplar::keepsBorders(maps, periodic, std::identity());
}
