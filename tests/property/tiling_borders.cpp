// SPDX-License-Identifier: MIT
// Which exemplars tile, and how the borders of others are blended.
#include "baked_exemplar.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <exemplar/borders.h>
#include <gaussian/cross_fade.h>

using namespace lichen;
using namespace lichen::test;
using namespace lichen::tiling;

TEST_CASE("an exemplar that tiles is told from a crop that does not") {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    const MapExemplar whole = threeMaterials(128, 128, seed);
    CHECK(exemplar::isPeriodic(whole));
    CHECK_FALSE(exemplar::isPeriodic(cropped(whole, 10, 0, 90, 128)));
    CHECK_FALSE(exemplar::isPeriodic(cropped(whole, 0, 20, 128, 77)));
  }
}

TEST_CASE("a strip too short to judge across is judged along") {
  MapExemplar ramp = threeMaterials(256, 6, 1, 1);
  for (std::size_t i = 0; i < ramp.values.size(); ++i)
    ramp.values[i] = float(i / 3 % 256) / 255.0f;
  CHECK_FALSE(exemplar::isPeriodic(ramp));
}

TEST_CASE("the seam itself shows the displaced image alone, at every size") {
  for (const int side : {8, 16, 64}) {
    const Baked b = baked(threeMaterials(side, side, 2, 1));
    const std::vector<Point> faded = gaussian::crossFadeBorders(b.gaussian.matched, side, side);
    // In the corners both cross-fades have weight 1: half a side away on both axes.
    for (const int y : {0, side - 1})
      for (const int x : {0, side - 1}) {
        const Point& displaced =
            b.gaussian.matched[std::size_t((y + side / 2) % side * side + (x + side / 2) % side)];
        INFO(side << ": " << x << ", " << y);
        CHECK(faded[std::size_t(y * side + x)].x == Approx(displaced.x).margin(1e-5));
      }
  }
}

TEST_CASE("blended borders continue each other as neighbours inside do") {
  const Baked b = baked(cropped(threeMaterials(128, 128, 6, 5), 5, 5, 96, 80));
  const std::vector<Point> faded = gaussian::crossFadeBorders(b.gaussian.matched, 96, 80);
  const auto meanStep = [&](const std::vector<Point>& image, int from, int to) {
    double sum = 0.0;
    for (int y = 0; y < 80; ++y) {
      const Point& p = image[std::size_t(y * 96 + from)];
      const Point& q = image[std::size_t(y * 96 + to)];
      sum += std::abs(double(p.x) - double(q.x)) + std::abs(double(p.y) - double(q.y));
    }
    return sum;
  };
  double inside = 0.0;
  for (int x = 0; x < 95; ++x)
    inside += meanStep(faded, x, x + 1) / 95.0;
  // Grain hides part of the seam: unrelated borders differ by a fifth more here.
  CHECK(meanStep(b.gaussian.matched, 95, 0) > 1.15 * inside);
  CHECK(meanStep(faded, 95, 0) < 1.1 * inside);
}
