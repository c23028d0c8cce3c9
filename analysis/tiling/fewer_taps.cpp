// SPDX-License-Identifier: MIT
// Three taps and a footprint -> the same taps, some with weight 0.
#include "fewer_taps.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lichen::tiling {
namespace {

/// How far the transition from all taps to one has progressed at a pixel, [0, 1].
float oneTapShare(const TileFootprint& at, float oneTapTiles) {
  if (oneTapTiles <= 0.0f)
    return 0.0f;
  // The side of a square with the pixel's area. More slanted pixels count as slanted by this much.
  constexpr float kMostSlant = 16.0f;
  const float squared = std::max(at.dx[0] * at.dx[0] + at.dx[1] * at.dx[1],
                                 at.dy[0] * at.dy[0] + at.dy[1] * at.dy[1]);
  const float area = std::abs(at.dx[0] * at.dy[1] - at.dx[1] * at.dy[0]);
  const float side = std::sqrt(std::max(area, squared / kMostSlant));
  return std::clamp(2.0f * side / oneTapTiles - 1.0f, 0.0f, 1.0f);
}

void sortByWeight(Taps& taps) {
  const auto order = [&](std::size_t a, std::size_t b) {
    if (taps.weight[a] < taps.weight[b]) {
      std::swap(taps.weight[a], taps.weight[b]);
      std::swap(taps.position[a], taps.position[b]);
      std::swap(taps.turn[a], taps.turn[b]);
    }
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
}

} // namespace

void reduceTaps(Taps& taps, const TileFootprint& at, const TilingQuality& quality) {
  if (quality.taps > 2 && quality.oneTapTiles <= 0.0)
    return;
  sortByWeight(taps);
  // Subtracting the smallest weight leaves two taps; on an edge of the triangle it is 0, so nothing
  // changes. Subtracting the second leaves one.
  const float least = quality.taps < 3 ? taps.weight[2] : 0.0f;
  const float second = taps.weight[1];
  const float share = oneTapShare(at, float(quality.oneTapTiles));
  const float taken = share < 1.0f ? least + share * (second - least) : second;
  float sum = 0.0f;
  for (float& weight : taps.weight) {
    weight = std::max(weight - taken, 0.0f);
    sum += weight;
  }
  if (sum > 0.0f)
    for (float& weight : taps.weight)
      weight /= sum;
  else // the largest weights are equal: either tap will do
    taps.weight[0] = 1.0f;
  taps.norm = std::hypot(taps.weight[0], taps.weight[1], taps.weight[2]);
}

} // namespace lichen::tiling
