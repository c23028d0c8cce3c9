// SPDX-License-Identifier: MIT
// Canvas, wicker, waffle cloth and corduroy.
#include "quilting_held_back_laying.h"

namespace lichen::test {
namespace {

float squared(float value) { return value * value; }

/// How far a thread stands out: 1 where it passes over, 0 where it passes under. Repeats after 2.
float over(float turns) {
  const float t = std::abs(turns - 2.0f * std::floor(0.5f * turns) - 1.0f); // 1, 0, 1
  return t * t * (3.0f - 2.0f * t);
}

/// Plain weave of two kinds of threads.
Spot canvas(Point p) {
  const float i = std::floor(p.x), j = std::floor(p.y);
  const float u = 2.0f * (p.x - i) - 1.0f, v = 2.0f * (p.y - j) - 1.0f;
  // Crossings are at the middles of squares.
  const float warp = std::sqrt(1.0f - squared(0.95f * u)) * (0.35f + 0.65f * over(i + p.y - 0.5f));
  const float weft = std::sqrt(1.0f - squared(0.95f * v)) * (0.35f + 0.65f * over(j + p.x + 0.5f));
  Spot spot;
  spot.height = std::max(warp, weft);
  if (warp > weft) {
    spot.middle = {i + 0.5f, 0.0f};
    spot.axis = {0.0f, 1.0f};
  } else {
    spot.middle = {0.0f, j + 0.5f};
  }
  return spot;
}

/// Round rods along x bend around stakes that are 2 apart, in front and behind by turns.
Spot wicker(Point p) {
  constexpr float kRod = 0.55f;
  const float row = std::floor(p.y / kRod), across = 2.0f * (p.y / kRod - row) - 1.0f;
  const float rod =
      std::sqrt(std::max(0.0f, 1.0f - across * across)) * (0.25f + 0.75f * over(0.5f * p.x + row));
  const float stakeAt = 2.0f * std::floor(0.5f * p.x) + 1.0f;
  const float off = (p.x - stakeAt) / 0.3f;
  const float stake = off * off < 1.0f ? 0.55f * std::sqrt(1.0f - off * off) : 0.0f;
  Spot spot;
  spot.height = std::max(rod, stake);
  if (stake > rod) {
    spot.middle = {stakeAt, 0.0f};
    spot.axis = {0.0f, 1.0f};
  } else {
    spot.middle = {0.0f, kRod * (row + 0.5f)};
  }
  return spot;
}

/// Ridges around square hollows, of threads an eighth wide.
Spot waffle(Point p) {
  const float x = std::abs(p.x - std::floor(p.x + 0.5f)),
              y = std::abs(p.y - std::floor(p.y + 0.5f));
  const float ridge = 1.0f - 2.0f * std::min(x, y); // 1 on ridges
  const float i = std::floor(8.0f * p.x), j = std::floor(8.0f * p.y);
  const float u = 16.0f * p.x - 2.0f * i - 1.0f, v = 16.0f * p.y - 2.0f * j - 1.0f;
  Spot spot;
  const bool isAlongX = y < x;
  spot.height = 0.75f * ridge * ridge + 0.25f * (1.0f - squared(isAlongX ? v : u));
  spot.middle = isAlongX ? Point{0.0f, (j + 0.5f) / 8.0f} : Point{(i + 0.5f) / 8.0f, 0.0f};
  spot.axis = isAlongX ? Point{1.0f, 0.0f} : Point{0.0f, 1.0f};
  return spot;
}

/// Wales along y.
Spot corduroy(Point p) {
  const float wale = std::floor(p.x), across = 2.0f * (p.x - wale) - 1.0f;
  Spot spot;
  spot.middle = {wale + 0.5f, 0.0f};
  spot.axis = {0.0f, 1.0f};
  spot.height = std::sqrt(1.0f - squared(squared(across)));
  return spot;
}

} // namespace

std::vector<Laying> clothLayings() {
  return {{"canvas", canvas, {2.0f, 2.0f}, Matter::yarn, false, 14.0f, 22.0f},
          {"wicker", wicker, {4.0f, 1.1f}, Matter::yarn, false, 12.0f, 20.0f},
          {"waffle", waffle, {1.0f, 1.0f}, Matter::yarn, false, 6.0f, 10.0f},
          {"corduroy", corduroy, {1.0f, 1.0f}, Matter::yarn, false, 10.0f, 16.0f}};
}

} // namespace lichen::test
