// SPDX-License-Identifier: MIT
// Which exemplars tile, and how the borders of the others are blended.
#include "baked_exemplar.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <exemplar/borders.h>
#include <gaussian/cross_fade.h>
#include <numbers>

using namespace lichen;
using namespace lichen::test;
using namespace lichen::gaussian;

TEST_CASE("a strip too narrow for seam detection across is tested along its length") {
  MapExemplar ramp = threeMaterials(256, 6, 1, 1);
  for (std::size_t i = 0; i < ramp.values.size(); ++i)
    ramp.values[i] = float(i / 3 % 256) / 255.0f;
  CHECK_FALSE(exemplar::isPeriodic(ramp));
}

TEST_CASE("at the seam a blended image is the displaced image, at every size") {
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

TEST_CASE("a blended image continues across its borders, and its middle is the exemplar's") {
  constexpr int kWidth = 96, kHeight = 80;
  // A sixteenth of each side is blended, except in the first and the last line.
  constexpr int kBandX = kWidth / 16, kBandY = kHeight / 16;
  const Baked b = baked(cropped(threeMaterials(128, 128, 6, 5), 5, 5, kWidth, kHeight));
  const std::vector<Point> faded = gaussian::crossFadeBorders(b.gaussian.matched, kWidth, kHeight);
  const auto isSame = [&](int x, int y, int fromX, int fromY) {
    const Point& p = faded[std::size_t(y * kWidth + x)];
    const Point& q = b.gaussian.matched[std::size_t(fromY * kWidth + fromX)];
    return std::abs(p.x - q.x) < 1e-6f && std::abs(p.y - q.y) < 1e-6f &&
           std::abs(p.z - q.z) < 1e-6f; // rounding of values below 1
  };
  int unlike = 0;
  for (int y = kBandY; y < kHeight - kBandY; ++y) {
    unlike += isSame(kWidth - 1, y, kWidth / 2 - 1, y) && isSame(0, y, kWidth / 2, y) ? 0 : 1;
    for (int x = kBandX; x < kWidth - kBandX; ++x)
      unlike += isSame(x, y, x, y) ? 0 : 1;
  }
  for (int x = kBandX; x < kWidth - kBandX; ++x)
    unlike += isSame(x, kHeight - 1, x, kHeight / 2 - 1) && isSame(x, 0, x, kHeight / 2) ? 0 : 1;
  CHECK(unlike == 0);
}

TEST_CASE("the weights of a blend preserve the variance and change little from pixel to pixel") {
  constexpr int kSide = 256, kBand = kSide / 16, kRow = kSide / 2;
  // Only one half differs from the mean beside the left border: its deviation is its weight.
  const auto weights = [&](bool displaced) {
    std::vector<Point> image(std::size_t(kSide) * kSide, Point{0.5f, 0.5f, 0.5f});
    for (std::size_t i = 0; i < image.size(); ++i)
      if ((int(i) % kSide >= kSide / 2) == displaced)
        image[i].x += 0.25f;
    const std::vector<Point> faded = gaussian::crossFadeBorders(image, kSide, kSide);
    std::vector<double> result;
    for (int x = 0; x <= kBand; ++x)
      result.push_back((double(faded[std::size_t(kRow * kSide + x)].x) - 0.5) / 0.25);
    return result;
  };
  const std::vector<double> own = weights(false), other = weights(true);
  double before = 0.5 * std::numbers::pi; // on the seam only the displaced image has weight
  for (std::size_t x = 0; x < own.size(); ++x) {
    CHECK(own[x] * own[x] + other[x] * other[x] == Approx(1.0).epsilon(1e-6)); // floats below 1
    const double angle = std::atan2(other[x], own[x]);
    // With weights 1 - w and w, the angle changes by at most 2 dw, and the smooth step w of t by at
    // most 3/2 dt, where dt is a pixel of the band. No pixel is a border of the blend.
    CHECK(angle <= before);
    CHECK(before - angle <= 3.0 / kBand);
    before = angle;
  }
  CHECK(before == Approx(0.0).margin(1e-6));
}
