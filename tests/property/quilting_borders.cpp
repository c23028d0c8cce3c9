// SPDX-License-Identifier: MIT
// Borders that quilting closes, of bars and of squares.
#include "plane_of.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <quilting/cells.h>
#include <quilting/closed_borders.h>
#include <random>
#include <vector>

using namespace lichen;
using lichen::quilting::cellsOf;
using lichen::quilting::closeBorders;

namespace {

constexpr int kWidth = 256, kHeight = 96; // of the pictures
constexpr int kPitch = 40, kJoint = 4;    // of the bars, pixels
constexpr double kBars = double(kWidth) / kPitch;
constexpr float kDark = 0.05f; // in joints

MapExemplar planeOf(const auto& valueAt) { return test::planeOf(kWidth, kHeight, valueAt); }

/// Upright bars of different greys, the first and the last of which the borders cut: 256 pixels
/// are 6.4 of them.
MapExemplar bars() {
  constexpr std::array<float, 7> kGreys{0.4f, 0.8f, 0.3f, 0.7f, 0.5f, 0.6f, 0.9f};
  return planeOf([&](int x, int) {
    const int bar = (x + kPitch / 2) / kPitch;
    const int within = (x + kPitch / 2) % kPitch;
    const bool isJoint = std::min(within, kPitch - 1 - within) < kJoint / 2;
    return isJoint ? kDark : kGreys[std::size_t(bar)];
  });
}

float at(const MapExemplar& map, int x, int y) {
  return map.values[std::size_t(y) * std::size_t(kWidth) + std::size_t(x)];
}

double meanOf(const MapExemplar& map) {
  return std::accumulate(map.values.begin(), map.values.end(), 0.0) / double(map.values.size());
}

void close(MapExemplar& map, double count, const std::vector<std::array<double, 2>>& shifts) {
  closeBorders({&map, 1}, cellsOf({&map, 1}, count), count, {shifts, shifts.empty() ? 1.0 : 0.0},
               ProgressPart());
}

} // namespace

TEST_CASE("a bar at a border is one of those a period further, whole and cut at its joints") {
  const MapExemplar cut = bars();
  REQUIRE(at(cut, 0, 0) != at(cut, kWidth - 1, 0));
  MapExemplar closed = cut;
  constexpr int kShift = 3 * kPitch;
  close(closed, kBars, {{0.0, 0.0}, {double(kShift) / kWidth, 0.0}});
  constexpr int kMiddle = 3 * kPitch;                                // of a bar
  const float change = at(closed, kMiddle, 0) - at(cut, kMiddle, 0); // which keeps the mean
  for (int y = 0; y < kHeight; ++y) {
    // Bar 3, from 100 to 139, is moved to between 236 and 19.
    for (int x = -kPitch / 2 + kJoint / 2; x < kPitch / 2 - kJoint / 2; ++x)
      REQUIRE(at(closed, (x + kWidth) % kWidth, y) ==
              Approx(at(cut, x + kShift, y) + change).margin(1e-6));
    // What is left of the bar beside it ends at a joint.
    float darkest = 1.0f;
    for (int x = kWidth - kPitch / 2 - kJoint; x < kWidth - kPitch / 2 + kJoint; ++x)
      darkest = std::min(darkest, at(closed, x, y));
    REQUIRE(darkest == Approx(kDark).margin(0.01));
    for (int x = kPitch / 2 + kJoint; x < kWidth - kPitch; ++x) // the others stay
      REQUIRE(at(closed, x, y) == Approx(std::max(at(cut, x, y) + change, kDark)).margin(1e-6));
  }
}

TEST_CASE("borders are closed by half a tile where nothing repeats, and mean and range stay") {
  constexpr int kSquare = 8;
  std::mt19937 generator(7u);
  std::uniform_real_distribution<float> uniform(-0.15f, 0.15f);
  std::array<std::array<float, kWidth / kSquare>, kHeight / kSquare> greys{};
  for (auto& row : greys)
    for (float& grey : row)
      grey = uniform(generator);
  const MapExemplar cut = planeOf([&](int x, int y) { // brighter in the middle
    const float fromMiddle = std::hypot(float(x) / kWidth - 0.5f, float(y) / kHeight - 0.5f);
    return 0.7f - 0.6f * fromMiddle + greys[std::size_t(y / kSquare)][std::size_t(x / kSquare)];
  });
  MapExemplar closed = cut;
  close(closed, double(kWidth / kSquare * kHeight / kSquare), {});
  const float change = at(closed, kWidth / 4, kHeight / 4) - at(cut, kWidth / 4, kHeight / 4);
  CHECK(change < -0.01f);
  const auto isMoved = [&](int x, int y, int fromX, int fromY) {
    return std::abs(at(closed, x, y) - at(cut, fromX, fromY) - change) < 1e-6f;
  };
  int moved = 0;
  for (int y = kHeight / 4; y < 3 * kHeight / 4; ++y)
    moved += isMoved(0, y, kWidth / 2, y) && isMoved(kWidth - 1, y, kWidth / 2 - 1, y) ? 1 : 0;
  for (int x = kWidth / 4; x < 3 * kWidth / 4; ++x)
    moved += isMoved(x, 0, x, kHeight / 2) && isMoved(x, kHeight - 1, x, kHeight / 2 - 1) ? 1 : 0;
  CHECK(moved > 0.8 * (kWidth + kHeight) / 2); // squares of like greys may be one large cell
  CHECK(meanOf(closed) == Approx(meanOf(cut)).margin(2e-3));
  CHECK(std::ranges::min(closed.values) >= std::ranges::min(cut.values));
  CHECK(std::ranges::max(closed.values) <= std::ranges::max(cut.values));
}

TEST_CASE("borders that meet in joints stay as they are") {
  const MapExemplar map = planeOf([](int x, int y) { // 4 joints of 64 pixels along each axis
    constexpr int kSquare = 64, kRows = kHeight / 2;
    const bool isJoint = std::min({x % kSquare, kSquare - 1 - x % kSquare, y % kRows,
                                   kRows - 1 - y % kRows}) < kJoint / 2;
    return isJoint ? kDark : 0.4f + 0.1f * float(x / kSquare) + 0.05f * float(y / kRows);
  });
  MapExemplar closed = map;
  close(closed, 8.0, {{0.0, 0.0}, {0.5, 0.0}, {0.5, 0.5}, {0.0, 0.5}});
  CHECK(closed.values == map.values);
}

TEST_CASE("borders are closed beside a map of one pixel, which stays as it is") {
  MapExemplar pixel;
  pixel.channels = {MapChannel::red};
  pixel.encoding = ValueEncoding::linear;
  pixel.width = pixel.height = 1;
  pixel.values = {0.5f};
  std::vector<MapExemplar> maps{bars(), pixel};
  closeBorders(maps, cellsOf(maps, kBars), kBars, {{{0.0, 0.0}, {3.0 * kPitch / kWidth, 0.0}}, 0.0},
               ProgressPart());
  CHECK(maps[0].values != bars().values);
  CHECK(maps[1].values == pixel.values);
}

TEST_CASE("closed borders leave 0 and 1 of a mask") {
  MapExemplar mask = bars();
  for (float& value : mask.values)
    value = value > 0.5f ? 1.0f : 0.0f;
  const std::vector<float> before = mask.values;
  close(mask, kBars, {{0.0, 0.0}, {3.0 * kPitch / kWidth, 0.0}});
  CHECK(mask.values != before);
  CHECK(std::ranges::all_of(mask.values, [](float v) { return v == 0.0f || v == 1.0f; }));
}

TEST_CASE("a border stays where no shift that repeats the exemplar is near half a tile") {
  for (const std::array<double, 2>& shift : {std::array{0.2, 0.0}, {0.45, 0.1}}) {
    MapExemplar map = bars();
    const std::vector<float> before = map.values;
    close(map, kBars, {{0.0, 0.0}, shift});
    CHECK(map.values == before);
  }
}
