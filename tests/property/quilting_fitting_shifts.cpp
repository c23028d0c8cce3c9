// SPDX-License-Identifier: MIT
// Shifts that bring edges onto edges, in sheet metal with grooves and rivets.
#include "plane_of.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <numbers>
#include <quilting/cells.h>
#include <quilting/fitting_shifts.h>
#include <random>
#include <vector>

using namespace lichen;
using lichen::quilting::cellsOf;
using lichen::quilting::FittingShifts;
using lichen::quilting::fittingShifts;

namespace {

using Shifts = std::vector<std::array<double, 2>>;

constexpr int kWidth = 256, kHeight = 192;
constexpr int kGroove = 32, kRow = 48; // periods of grooves and of rows of rivets [pixels]
constexpr double kCount = double(kWidth / kGroove) * (kHeight / kRow);

/// Upright grooves, and a dark rivet in each of them in each row, up to a pixel from its place; or
/// as many anywhere.
MapExemplar metal(bool inRows) {
  constexpr double kRadius = 5.0;
  MapExemplar map = test::planeOf(kWidth, kHeight, [](int x, int) {
    return 0.6 + 0.2 * std::cos(2.0 * std::numbers::pi * (x + 0.5) / kGroove);
  });
  std::mt19937 bits(5u);
  const auto upTo = [&](int most) { return int(bits() % std::uint32_t(most)); };
  for (int row = 0; row < kHeight / kRow; ++row)
    for (int groove = 0; groove < kWidth / kGroove; ++groove) {
      const int centreX = inRows ? groove * kGroove + kGroove / 2 + upTo(3) - 1 : upTo(kWidth);
      const int centreY = inRows ? row * kRow + kRow / 2 + upTo(3) - 1 : upTo(kHeight);
      for (int y = -int(kRadius); y <= int(kRadius); ++y)
        for (int x = -int(kRadius); x <= int(kRadius); ++x)
          if (std::hypot(x, y) <= kRadius)
            map.values[std::size_t((centreY + y + kHeight) % kHeight * kWidth +
                                   (centreX + x + kWidth) % kWidth)] = 0.05f;
    }
  return map;
}

/// Whole grooves to the right, up to half a tile, and so many pixels down.
Shifts shiftsDown(std::initializer_list<int> downs) {
  Shifts shifts;
  for (const int down : downs)
    for (int right = 0; right < kWidth / 2; right += kGroove)
      shifts.push_back({double(right) / kWidth, double(down) / kHeight});
  return shifts;
}

FittingShifts fittingOf(bool inRows, const Shifts& shifts) {
  const MapExemplar map = metal(inRows);
  return fittingShifts(cellsOf({&map, 1}, kCount), shifts);
}

} // namespace

TEST_CASE("of shifts along grooves those stay that bring rivets onto rivets") {
  const Shifts fit = shiftsDown({0, kRow, -kRow}), others = shiftsDown({kRow / 2, -kRow / 4, 10});
  Shifts all;
  for (std::size_t k = 0; k < fit.size(); ++k) // the order stays
    all.insert(all.end(), {fit[k], others[k]});
  const FittingShifts fitting = fittingOf(true, all);
  CHECK(fitting.shifts == fit);
  CHECK(fitting.miss > 0.0);
  CHECK(fitting.isClose());
}

TEST_CASE("shifts that all fit stay, though some fit better") {
  const Shifts fit = shiftsDown({0, kRow, -kRow});
  REQUIRE(fit.size() > 9);
  CHECK(fittingOf(true, fit).shifts == fit);
}

TEST_CASE("at least nine shifts stay, those that fit best") {
  const Shifts few = shiftsDown({0}), others = shiftsDown({kRow / 2, -kRow / 4, 10});
  Shifts all = few;
  all.insert(all.end(), others.begin(), others.end());
  const Shifts kept = fittingOf(true, all).shifts;
  CHECK(kept.size() == 9);
  CHECK(std::equal(few.begin(), few.end(), kept.begin()));
}

TEST_CASE("rivets that are anywhere do not fit, and without shifts nothing does") {
  CHECK_FALSE(fittingOf(false, shiftsDown({0, kRow, -kRow})).isClose());
  const FittingShifts none = fittingOf(true, {});
  CHECK(none.shifts.empty());
  CHECK_FALSE(none.isClose());
  CHECK(fittingOf(true, {{0.0, 0.0}}).shifts == Shifts{{0.0, 0.0}});
}
