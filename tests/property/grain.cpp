// SPDX-License-Identifier: MIT
// Which exemplars have a grain, along which axis, and how borders fade along it.
#include "bundle_of.h"
#include "measured_cloudiness.h"
#include "statistics_of_maps.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstddef>
#include <exemplar/grain.h>
#include <gaussian/cross_fade.h>
#include <materials.h>
#include <photographs.h>
#include <random>
#include <surfaces.h>
#include <unsuitable.h>
#include <vector>

using namespace lichen;
using lichen::exemplar::grainOf;
using lichen::test::baseColor;
using lichen::test::bundleOf;
using lichen::test::channelOf;
using lichen::test::correlationOf;

namespace {

constexpr int kSide = 256;

SrgbImage transposed(const SrgbImage& image) {
  SrgbImage result = image;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < 3; ++c)
        result.pixel(y, x)[c] = image.pixel(x, y)[c];
  return result;
}

/// Rows of Gaussian values, each a process that correlates by exp(-distance / length).
std::vector<Point> streaks(int width, int height, double length) {
  std::mt19937 bits(7);
  std::normal_distribution<double> normal;
  const double kept = std::exp(-1.0 / length), fresh = std::sqrt(1.0 - kept * kept);
  std::vector<Point> image;
  for (int y = 0; y < height; ++y) {
    double value = normal(bits);
    for (int x = 0; x < width; ++x) {
      image.push_back({float(0.5 + value / 6.0), 0.0f, 0.0f}); // unused channels are 0
      value = kept * value + fresh * normal(bits);
    }
  }
  return image;
}

/// The correlation of the green of pixels `distance` rows apart.
double correlationAlongY(const LinearImage& image, int distance) {
  const std::vector<double> all = channelOf(image.values, 3, 1);
  const auto apart = std::ptrdiff_t(distance) * image.width;
  return correlationOf({all.begin(), all.end() - apart}, {all.begin() + apart, all.end()});
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

TEST_CASE("along a grain a blended image continues across its borders") {
  constexpr int kWidth = 96, kHeight = 64, kBand = kWidth / 16;
  const std::vector<Point> rows = streaks(kHeight, kWidth, 20.0); // kWidth rows
  std::vector<Point> image(rows.size());                          // their columns, kHeight high
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      image[std::size_t(y * kWidth + x)] = rows[std::size_t(x * kHeight + y)];
  const std::vector<Point> faded = gaussian::crossFadeBorders(image, kWidth, kHeight, Grain::y);
  for (int x = kBand; x < kWidth - kBand; ++x) {
    INFO(x);
    const auto at = [x](int y) { return std::size_t(y * kWidth + x); };
    CHECK(faded[at(0)].x == Approx(image[at(kHeight / 2)].x).margin(1e-5));
    CHECK(faded[at(kHeight - 1)].x == Approx(image[at(kHeight / 2 - 1)].x).margin(1e-5));
  }
}

TEST_CASE("the fade along a grain preserves the variance of streaks as long as the image") {
  // 2048 rows of 64 values, whose variance is known to 4 % at each column: five standard errors.
  constexpr int kWidth = 64, kHeight = 2048, kBand = kHeight / 16;
  const std::vector<Point> image = streaks(kWidth, kHeight, kWidth);
  const std::vector<Point> faded = gaussian::crossFadeBorders(image, kWidth, kHeight, Grain::x);
  for (int x = 0; x < kWidth; ++x) {
    double squares = 0.0;
    for (int y = kBand; y < kHeight - kBand; ++y) {
      const double value = 6.0 * (double(faded[std::size_t(y * kWidth + x)].x) - 0.5);
      squares += value * value;
    }
    INFO("column " << x);
    CHECK(squares / (kHeight - 2 * kBand) == Approx(1.0).margin(0.17));
  }
}

TEST_CASE("the noise of wood has streaks as long as the exemplar's", "[large]") {
  const SrgbImage surface = exemplars::photographedSurface("wood_grain", kSide);
  const MapExemplar wood =
      baseColor(exemplars::photograph(surface, {"wood_grain", exemplars::Fault::none, 0, 3}).image);
  LinearImage exemplar(wood.width, wood.height, 3);
  exemplar.values = test::decodedValues(wood);
  // About 200 streaks lie in the result, so that a correlation is known to 0.07.
  const Bundle bundle = bundleOf(bakeTiling("wood", {&wood, 1}, {}));
  CHECK(bundle.noises[0].as<TilingNoise>().grain == Grain::y);
  const LinearImage noise = test::synthesized(bundle, MapTarget::baseColor);
  for (const int distance : {wood.height / 8, wood.height / 4}) {
    const double wanted = correlationAlongY(exemplar, distance);
    INFO(distance << " rows, exemplar " << wanted);
    CHECK(correlationAlongY(noise, distance) == Approx(wanted).margin(0.15));
  }
}
