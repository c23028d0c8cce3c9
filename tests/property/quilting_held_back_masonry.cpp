// SPDX-License-Identifier: MIT
// Stones and tiles: ashlar, pavers in two sizes, hexagons, octagons with dots, and roof tiles.
#include "quilting_held_back_laying.h"

#include <array>

namespace lichen::test {
namespace {

constexpr float kRoot3 = 1.7320508f;

/// Three courses of different heights, each of a long and a short stone.
Spot ashlar(Point p) {
  struct Course {
    float top, height, start;
  };
  constexpr std::array<Course, 3> kCourses{
      {{0.0f, 1.0f, 0.0f}, {1.0f, 0.6f, 0.9f}, {1.6f, 0.8f, 1.75f}}};
  constexpr float kHeight = 2.4f, kLong = 1.65f, kPair = 2.7f;
  const float storey = std::floor(p.y / kHeight) * kHeight, y = p.y - storey;
  const Course& course = kCourses[y < 1.0f ? 0 : y < 1.6f ? 1 : 2];
  const float pair = std::floor((p.x - course.start) / kPair) * kPair + course.start;
  const bool isLong = p.x - pair < kLong;
  const float width = isLong ? kLong : kPair - kLong;
  return rectangle(
      p,
      {pair + (isLong ? 0.0f : kLong) + 0.5f * width, storey + course.top + 0.5f * course.height},
      {0.5f * width, 0.5f * course.height});
}

/// A large and a small square tile the plane, as in a proof of Pythagoras.
Spot hopscotch(Point p) {
  const float a = std::floor((2.0f * p.x + p.y) / 5.0f), b = std::floor((2.0f * p.y - p.x) / 5.0f);
  Spot best;
  best.inside = -1.0f;
  for (float i = a - 2.0f; i <= a + 2.0f; i += 1.0f)
    for (float j = b - 2.0f; j <= b + 2.0f; j += 1.0f) {
      const Point corner{2.0f * i - j, i + 2.0f * j};
      for (const Spot& spot : {rectangle(p, {corner.x + 1.0f, corner.y + 1.0f}, {1.0f, 1.0f}),
                               rectangle(p, {corner.x + 2.5f, corner.y + 0.5f}, {0.5f, 0.5f})})
        if (spot.inside > best.inside)
          best = spot;
    }
  return best;
}

/// Hexagons with sides of 1 / sqrt(3), so that they are 1 wide.
Spot hexagons(Point p) {
  constexpr float kRow = 0.5f * kRoot3;
  Spot best;
  best.inside = -1.0f;
  const float row0 = std::floor(p.y / kRow);
  for (float row = row0 - 1.0f; row <= row0 + 2.0f; row += 1.0f) {
    const float start = isOdd(row) ? 0.5f : 0.0f;
    const Point middle{std::floor(p.x - start + 0.5f) + start, row * kRow};
    const float dx = std::abs(p.x - middle.x), dy = std::abs(p.y - middle.y);
    const float inside = 0.5f - std::max(dx, 0.5f * dx + 0.5f * kRoot3 * dy);
    if (inside > best.inside) {
      best.inside = inside;
      best.middle = middle;
    }
  }
  return best;
}

Spot octagons(Point p) {
  constexpr float kDot = 0.3f, kRoot2 = 1.4142136f;
  const Point corner{std::floor(p.x + 0.5f), std::floor(p.y + 0.5f)};
  const float toDot = (std::abs(p.x - corner.x) + std::abs(p.y - corner.y) - kDot) / kRoot2;
  if (toDot < 0.0f) {
    Spot dot;
    dot.middle = corner;
    dot.inside = -toDot;
    return dot;
  }
  Spot spot = rectangle(p, {std::floor(p.x) + 0.5f, std::floor(p.y) + 0.5f}, {0.5f, 0.5f});
  spot.inside = std::min(spot.inside, toDot);
  return spot;
}

/// Tiles with a semicircular end; each row covers all but the ends of the next.
Spot beaverTails(Point p) {
  constexpr float kRow = 0.55f, kRadius = 0.5f;
  Spot spot;
  float above = 1.0f; // distance to the tiles on top
  for (float row = std::floor((p.y - kRadius) / kRow);; row += 1.0f) {
    const float start = isOdd(row) ? 0.5f : 0.0f;
    const Point middle{std::floor(p.x - start) + start + 0.5f, row * kRow};
    const float dx = p.x - middle.x, dy = std::max(p.y - middle.y, 0.0f);
    const float radius = std::sqrt(dx * dx + dy * dy);
    if (radius <= kRadius) {
      spot.middle = middle;
      spot.axis = {0.0f, 1.0f};
      spot.inside = std::min(kRadius - radius, above);
      spot.slant = 1.6f * (p.y - middle.y) - 0.1f;
      return spot;
    }
    above = std::min(above, radius - kRadius);
  }
}

} // namespace

std::vector<Laying> masonryLayings() {
  return {{"ashlar", ashlar, {2.7f, 2.4f}, Matter::stone, false, 7.0f, 11.0f},
          {"hopscotch", hopscotch, {5.0f, 5.0f}, Matter::stone, false, 13.0f, 19.0f},
          {"hexagons", hexagons, {1.0f, kRoot3}, Matter::ceramic, false, 6.0f, 11.0f},
          {"octagons", octagons, {1.0f, 1.0f}, Matter::ceramic, false, 6.0f, 10.0f},
          {"beaver tails", beaverTails, {1.0f, 1.1f}, Matter::stone, true, 6.0f, 10.0f}};
}

} // namespace lichen::test
