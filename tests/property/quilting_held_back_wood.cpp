// SPDX-License-Identifier: MIT
// Parquet: basket weave and chevron.
#include "quilting_held_back_laying.h"

namespace lichen::test {
namespace {

/// Squares of three staves, which lie along x and along y by turns.
Spot basket(Point p) {
  const float column = std::floor(p.x), row = std::floor(p.y);
  const bool isAlongX = isOdd(column + row);
  const float across = isAlongX ? p.y - row : p.x - column;
  const float middle = (std::min(std::floor(3.0f * across), 2.0f) + 0.5f) / 3.0f;
  return isAlongX ? rectangle(p, {column + 0.5f, row + middle}, {0.5f, 1.0f / 6.0f})
                  : rectangle(p, {column + middle, row + 0.5f}, {1.0f / 6.0f, 0.5f});
}

/// Slanted staves that meet in points.
Spot chevron(Point p) {
  constexpr float kRise = 0.8f, kWidth = 0.32f;
  const float strip = std::floor(p.x), x = p.x - strip;
  const float rise = isOdd(strip) ? kRise : -kRise;
  const float y = p.y + rise * (x - 0.5f), stave = std::floor(y / kWidth);
  const float length = std::sqrt(1.0f + kRise * kRise);
  Spot spot;
  spot.middle = {strip + 0.5f, kWidth * (stave + 0.5f)};
  spot.axis = {1.0f / length, -rise / length};
  const float across = y - kWidth * stave;
  spot.inside = std::min({across / length, (kWidth - across) / length, x, 1.0f - x});
  return spot;
}

} // namespace

std::vector<Laying> woodLayings() {
  return {{"basket", basket, {2.0f, 2.0f}, Matter::wood, false, 6.0f, 9.0f},
          {"chevron", chevron, {2.0f, 0.32f}, Matter::wood, false, 5.0f, 8.0f}};
}

} // namespace lichen::test
