// SPDX-License-Identifier: MIT
// Which exemplars have a grain, along which axis, and how borders fade along it.
#include "base_color.h"
#include "bundle_of.h"
#include "plane_of.h"
#include "statistics_of_maps.h"

#include <lichen/quilting.h>
#include <lichen/tiling.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exemplar/grain.h>
#include <gaussian/cross_fade.h>
#include <gaussian/gaussianized_maps.h>
#include <materials.h>
#include <numbers>
#include <photographs.h>
#include <random>
#include <surfaces.h>
#include <unsuitable.h>
#include <utility>
#include <vector>

using namespace lichen;
using lichen::exemplar::grainOf;
using lichen::test::baseColor;
using lichen::test::bundleOf;
using lichen::test::channelOf;
using lichen::test::correlationOf;

namespace {

constexpr int kSide = 256;
constexpr int kSmall = 64;

SrgbImage transposed(const SrgbImage& image) {
  SrgbImage result = image;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < 3; ++c)
        result.pixel(y, x)[c] = image.pixel(x, y)[c];
  return result;
}

/// Rows of values of mean 0 and variance 1, each a Gaussian process that correlates by
/// exp(-distance / length).
std::vector<double> streakValues(int width, int height, double length, std::uint32_t seed) {
  std::mt19937 bits(seed);
  std::normal_distribution<double> normal;
  const double correlation = std::exp(-1.0 / length);
  const double fresh = std::sqrt(1.0 - correlation * correlation);
  std::vector<double> values;
  for (int y = 0; y < height; ++y) {
    double value = normal(bits);
    for (int x = 0; x < width; ++x) {
      values.push_back(value);
      value = correlation * value + fresh * normal(bits);
    }
  }
  return values;
}

constexpr float Point::*kChannels[] = {&Point::x, &Point::y, &Point::z};

/// A Gaussian image of such rows in each channel. Channels above `dimensions` are 0.
std::vector<Point> streaks(int width, int height, double length, int dimensions = 1) {
  std::vector<Point> image(std::size_t(width) * std::size_t(height), Point{0.0f, 0.0f, 0.0f});
  for (int channel = 0; channel < dimensions; ++channel) {
    const std::vector<double> values =
        streakValues(width, height, length, 7u + std::uint32_t(channel));
    for (std::size_t i = 0; i < image.size(); ++i)
      image[i].*kChannels[channel] = float(0.5 + values[i] / 6.0);
  }
  return image;
}

/// Streaks about three pixels wide at an angle to the x axis, which correlate by
/// exp(-distance / length).
MapExemplar turnedStreaks(int side, double degrees, double length) {
  const int wide = 2 * side;
  const std::vector<double> rows = streakValues(wide, wide, length, 3);
  const double angle = degrees * std::numbers::pi / 180.0;
  return test::planeOf(side, side, [&](int x, int y) {
    const double fromX = x - 0.5 * side, fromY = y - 0.5 * side;
    const double along = fromX * std::cos(angle) + fromY * std::sin(angle) + side;
    const double across = fromY * std::cos(angle) - fromX * std::sin(angle) + side;
    double sum = 0.0;
    for (int row = int(across) - 4; row <= int(across) + 5; ++row) {
      const double distance = row - across;
      sum += std::exp(-0.5 * distance * distance) * rows[std::size_t(row * wide + int(along))];
    }
    return 0.5 + 0.1 * sum;
  });
}

/// Rows of one wave each, at phases in a random order, so that pixels `lag` apart along x correlate
/// by `correlation` and rows do not.
MapExemplar waves(int width, int height, double lag, double correlation) {
  std::mt19937 bits(5);
  std::vector<int> phases(std::size_t(height), 0);
  for (int y = 1; y < height; ++y) {
    const std::size_t other = bits() % std::size_t(y + 1);
    phases[std::size_t(y)] = phases[other];
    phases[other] = y;
  }
  const double frequency = std::acos(correlation) / lag; // radians per pixel
  return test::planeOf(width, height, [&](int x, int y) {
    const double phase = 2.0 * std::numbers::pi * phases[std::size_t(y)] / height;
    return 0.5 + 0.3 * std::cos(frequency * x + phase);
  });
}

MapExemplar transposed(const MapExemplar& map) {
  return test::planeOf(map.height, map.width, [&](int x, int y) {
    return map.values[std::size_t(x) * std::size_t(map.width) + std::size_t(y)];
  });
}

} // namespace

TEST_CASE("wood has a grain along its streaks, and materials without long streaks have none") {
  const SrgbImage wood = exemplars::photographedSurface("wood_grain", kSide);
  CHECK(grainOf(baseColor(wood)) == Grain::y);
  CHECK(grainOf(baseColor(transposed(wood))) == Grain::x);
  MapExemplar slopes = baseColor(wood);
  slopes.encoding = ValueEncoding::slope;
  CHECK(grainOf(slopes) == Grain::none);
  for (SrgbImage (*generate)(int) : {exemplars::granite, exemplars::moss, exemplars::rust,
                                     exemplars::sand, exemplars::bricks, exemplars::weave})
    CHECK(grainOf(baseColor(generate(kSide))) == Grain::none);
}

TEST_CASE("streaks at any angle have the nearer axis as their grain") {
  for (int degrees = 0; degrees < 180; degrees += 5) {
    const Grain grain = grainOf(turnedStreaks(kSide, degrees, 0.5 * kSide));
    INFO(degrees << " degrees: " << nameOf(grain));
    CHECK(grain != Grain::none);
    if (degrees % 90 != 45)
      CHECK(grain == (degrees < 45 || degrees > 135 ? Grain::x : Grain::y));
  }
}

TEST_CASE("streaks are long if pixels two sevenths of the side along them apart correlate by 0.2") {
  constexpr double kSeventh = 1.0 / 7.0;
  // Phases that are evenly spaced leave correlations exact to 0.02 here.
  for (const auto& [width, height] : {std::pair{256, 256}, {512, 256}, {256, 512}, {257, 301}}) {
    INFO(width << " x " << height);
    const double lag = 2.0 * kSeventh * width;
    CHECK(grainOf(waves(width, height, lag, 0.15)) == Grain::none);
    CHECK(grainOf(waves(width, height, lag, 0.25)) == Grain::x);
    CHECK(grainOf(transposed(waves(width, height, lag, 0.15))) == Grain::none);
    CHECK(grainOf(transposed(waves(width, height, lag, 0.25))) == Grain::y);
  }
}

TEST_CASE("pictures under 64 pixels a side have no grain") {
  const auto endless = [](int width, int height) {
    const std::vector<double> rows = streakValues(1, height, 1.0, 7);
    return test::planeOf(width, height,
                         [&](int, int y) { return 0.5 + 0.1 * rows[std::size_t(y)]; });
  };
  CHECK(grainOf(endless(64, 64)) == Grain::x);
  CHECK(grainOf(endless(65, 97)) == Grain::x);
  CHECK(grainOf(endless(63, 256)) == Grain::none);
  CHECK(grainOf(endless(256, 63)) == Grain::none);
}

TEST_CASE("the first map of a set decides the grain of all") {
  const std::vector<double> white = streakValues(kSmall * kSmall, 1, 0.1, 9);
  const MapExemplar sand = test::planeOf(
      kSmall, kSmall, [&](int x, int y) { return 0.5 + 0.1 * white[std::size_t(y * kSmall + x)]; });
  MapExemplar wood = turnedStreaks(kSmall, 0.0, kSmall);
  wood.target = MapTarget::opacity;
  wood.channels = {MapChannel::opacity};
  for (const bool woodFirst : {false, true}) {
    const std::vector<MapExemplar> maps =
        woodFirst ? std::vector{wood, sand} : std::vector{sand, wood};
    TilingOptions options;
    options.periodic = Periodic::no;
    const Bundle bundle = bundleOf(bakeTiling("set", maps, options));
    const Grain expected = woodFirst ? Grain::x : Grain::none;
    CHECK(bundle.noises[0].as<TilingNoise>().grain == expected);
    const Bundle quilting = bundleOf(bakeQuilting("set", maps, {}));
    CHECK(quilting.noises[0].as<QuiltingNoise>().grain == expected);
  }
}

TEST_CASE("only a bake that uses the grain finds one") {
  const MapExemplar wood = turnedStreaks(kSmall, 90.0, kSmall);
  GaussianizationOptions options;
  options.periodic = Periodic::no;
  std::vector<std::vector<Point>> images;
  for (const auto& [uses, grain] :
       {std::pair{gaussian::UsesGrain::yes, Grain::y}, {gaussian::UsesGrain::no, Grain::none}}) {
    const auto borders = gaussian::gaussianizeMaps(
        "wood", {&wood, 1}, options, uses,
        [&](gaussian::GaussianizedMap map) { images.push_back(map.image.image); });
    CHECK(borders.value().grain == grain);
    CHECK_FALSE(borders.value().fit);
  }
  // An eighth of the side from the border only streaks fade.
  const auto row = std::size_t(kSmall / 8 * kSmall);
  double difference = 0.0;
  for (std::size_t x = 0; x < std::size_t(kSmall); ++x)
    difference += std::abs(double(images[0][row + x].x) - double(images[1][row + x].x));
  CHECK(difference / kSmall > 0.01);
}

TEST_CASE("streaks without an end stay as they are, and fade only into those beside them") {
  constexpr int kWidth = 96, kHeight = 64, kBand = kHeight / 16;
  std::vector<Point> image = streaks(1, kHeight, 0.1), wide;
  for (const Point& value : image)
    wide.insert(wide.end(), kWidth, value);
  const std::vector<Point> faded = gaussian::crossFadeBorders(wide, kWidth, kHeight, Grain::x);
  for (int y = kBand; y < kHeight - kBand; ++y)
    for (int x = 0; x < kWidth; ++x) {
      INFO(x << ", " << y);
      const auto i = std::size_t(y * kWidth + x);
      REQUIRE(faded[i].x == Approx(wide[i].x).margin(1e-5));
    }
}

TEST_CASE("along a grain a blended image continues across its borders, at odd sizes too") {
  for (const auto& [width, height] : {std::pair{96, 64}, {97, 65}, {64, 97}}) {
    const int band = width / 16 + 1;
    const std::vector<Point> rows = streaks(height, width, 20.0); // one for each column
    std::vector<Point> image(rows.size());
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        image[std::size_t(y * width + x)] = rows[std::size_t(x * height + y)];
    const std::vector<Point> faded = gaussian::crossFadeBorders(image, width, height, Grain::y);
    for (int x = band; x < width - band; ++x) {
      INFO(width << " x " << height << ", column " << x);
      const auto at = [x, stride = width](int y) { return std::size_t(y * stride + x); };
      CHECK(faded[at(0)].x == Approx(image[at(height / 2)].x).margin(1e-5));
      CHECK(faded[at(height - 1)].x == Approx(image[at(height / 2 - 1)].x).margin(1e-5));
    }
  }
}

TEST_CASE("the fade along a grain preserves the variance of streaks as long as the image, in 1, 2 "
          "and 3 dimensions") {
  // 2048 rows of 64 values, whose variance is known to 4 % at each column: five standard errors
  // over 384 columns.
  constexpr int kWidth = 64, kHeight = 2048, kBand = kHeight / 16;
  for (int dimensions = 1; dimensions <= 3; ++dimensions) {
    const std::vector<Point> image = streaks(kWidth, kHeight, kWidth, dimensions);
    const std::vector<Point> faded = gaussian::crossFadeBorders(image, kWidth, kHeight, Grain::x);
    for (int channel = 0; channel < dimensions; ++channel)
      for (int x = 0; x < kWidth; ++x) {
        double squares = 0.0;
        for (int y = kBand; y < kHeight - kBand; ++y) {
          const Point& point = faded[std::size_t(y * kWidth + x)];
          const double value = 6.0 * (double(point.*kChannels[channel]) - 0.5);
          squares += value * value;
        }
        INFO("channel " << channel << " of " << dimensions << ", column " << x);
        CHECK(squares / (kHeight - 2 * kBand) == Approx(1.0).margin(0.17));
      }
  }
}
