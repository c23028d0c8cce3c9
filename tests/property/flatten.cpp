// SPDX-License-Identifier: MIT
// What flattening removes and what it keeps, by waves, spectra and the cloudiness that is left.
#include "example_exemplar.h"
#include "measured_cloudiness.h"

#include <lichen/flatten.h>
#include <lichen/spectrum.h>
#include <lichen/suitability.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <materials.h>
#include <numbers>
#include <unsuitable.h>

using namespace lichen;
using lichen::test::baseColor;

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// Two slopes a pixel, the second zero.
template <typename SlopeAt>
MapExemplar slopes(int width, int height, const SlopeAt& slopeAt) {
  MapExemplar map;
  map.target = MapTarget::normal;
  map.channels = {MapChannel::slopeX, MapChannel::slopeY};
  map.encoding = ValueEncoding::slope;
  map.width = width;
  map.height = height;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      map.values.push_back(float(slopeAt(x, y)));
      map.values.push_back(0.0f);
    }
  return map;
}

MapExemplar flattened(MapExemplar map, double period, bool periodic = true) {
  REQUIRE(flatten({&map, 1}, period, periodic).ok());
  return map;
}

/// Amplitude of the first channel's wave of `cycles` across the map.
double amplitude(const MapExemplar& map, int cycles) {
  std::complex<double> sum = 0.0;
  const std::size_t channels = map.channels.size();
  for (std::size_t i = 0; i < map.values.size() / channels; ++i)
    sum += double(map.values[i * channels]) *
           std::polar(1.0, -kTurn * cycles * double(i % std::size_t(map.width)) / map.width);
  return (cycles == 0 ? 1.0 : 2.0) * std::abs(sum) * double(channels) / double(map.values.size());
}

double scoreOf(const MapExemplar& map, std::string_view name, bool periodic) {
  const Result<std::vector<Risk>> risks = assessSuitability(map, periodic);
  REQUIRE(risks.ok());
  for (const Risk& risk : risks.value())
    if (risk.name == name)
      return risk.score;
  FAIL("no risk " << name);
  return 0.0;
}

std::optional<double> automaticPeriod(const MapExemplar& map, bool periodic) {
  const Result<std::optional<double>> period = flatteningPeriod(map, periodic);
  REQUIRE(period.ok());
  return period.value();
}

SrgbImage imageOf(const MapExemplar& map) {
  SrgbImage image(map.width, map.height, 3);
  image.values = map.values;
  return image;
}

double rootMeanSquare(const std::vector<float>& a, const std::vector<float>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += std::pow(double(a[i]) - double(b[i]), 2.0);
  return std::sqrt(sum / double(a.size()));
}

} // namespace

TEST_CASE("Waves of the period are halved, shorter ones kept, longer ones and no mean removed") {
  constexpr int kWidth = 120, kHeight = 50;
  const auto waves = [](int x, int) {
    double sum = 0.25;
    for (const int cycles : {1, 4, 8, 16})
      sum += 0.1 * std::cos(kTurn * cycles * x / kWidth);
    return sum;
  };
  const MapExemplar map = flattened(slopes(kWidth, kHeight, waves), kWidth / 4.0);
  // 1 - 2^-(cycles / 4)^2, to float rounding.
  CHECK(amplitude(map, 0) == Approx(0.25).epsilon(1e-5));
  CHECK(amplitude(map, 1) == Approx(0.1 * (1.0 - std::exp2(-1.0 / 16.0))).epsilon(1e-4));
  CHECK(amplitude(map, 4) == Approx(0.05).epsilon(1e-4));
  CHECK(amplitude(map, 8) == Approx(0.1 * 15.0 / 16.0).epsilon(1e-4));
  CHECK(amplitude(map, 16) == Approx(0.1).epsilon(1e-4));
}

TEST_CASE("A ramp goes without a trace at the borders where the exemplar does not tile") {
  constexpr int kSide = 64;
  const MapExemplar ramp = slopes(kSide, kSide, [](int x, int) { return double(x) / kSide; });
  // The mirror image turns the ramp into a wave of twice the side, of which the period of half a
  // side leaves 1 - 2^-(1/16); its harmonics, odd and falling with their square, are left more.
  // Continued by itself the ramp would jump by 1 at the border.
  const auto border = [](const MapExemplar& map) {
    return std::abs(double(map.values[0]) - 0.5 * double(kSide - 1) / kSide);
  };
  CHECK(border(flattened(ramp, kSide / 2.0, false)) < 0.1);
  CHECK(border(flattened(ramp, kSide / 2.0, true)) > 0.3);
}

TEST_CASE("Uneven light goes as a factor: what is left is what even light shows") {
  const MapExemplar lit = baseColor(exemplars::slopingLight(128));
  const MapExemplar even = baseColor(exemplars::sand(128));
  const MapExemplar flatLit = flattened(lit, 128.0, false);
  const MapExemplar flatEven = flattened(even, 128.0, false);
  // What the period leaves of the slope's border, clipped highlights and rounding to 8 bits: 0.28.
  CHECK(rootMeanSquare(flatLit.values, flatEven.values) <
        0.35 * rootMeanSquare(lit.values, even.values));
  double before = 0.0, after = 0.0;
  for (std::size_t i = 0; i < lit.values.size(); ++i) {
    before += double(srgbToLinear(lit.values[i]));
    after += double(srgbToLinear(flatLit.values[i]));
  }
  CHECK(after == Approx(before).epsilon(0.01)); // but for clipped highlights
}

TEST_CASE("Detail faster than the period is kept") {
  const MapExemplar carpet = baseColor(exemplars::carpet(128));
  const MapExemplar flat = flattened(carpet, 64.0);
  const auto power = [](const MapExemplar& map) {
    return radialPowerSpectrum(luminancePlane(imageOf(map)), map.width, map.height, 64);
  };
  const std::vector<double> before = power(carpet), after = power(flat);
  // From 4 cycles per period, of which the filter keeps all but 2^-16; the factor by which dark
  // places are brightened moves power between frequencies: up to 6 %.
  for (std::size_t ring = 4; ring < before.size(); ++ring) {
    INFO("ring " << ring);
    CHECK(after[ring] == Approx(before[ring]).epsilon(0.1));
  }
}

TEST_CASE("Auto flattens a cloudy exemplar no more than is needed") {
  const MapExemplar carpet = baseColor(exemplars::carpet(128));
  const std::optional<double> period = automaticPeriod(carpet, true);
  REQUIRE(period.has_value());
  const MapExemplar flat = flattened(carpet, *period);
  for (const std::string_view name : {"cloudiness", "low-frequency"})
    CHECK(scoreOf(flat, name, true) < 1.0 / 3.0);
  const MapExemplar less = flattened(carpet, std::numbers::sqrt2 * *period);
  CHECK(std::max(scoreOf(less, "cloudiness", true), scoreOf(less, "low-frequency", true)) >=
        1.0 / 3.0);
  // As measured on the decoded noise: from about 0.27 to 0.1 and less.
  constexpr int kSamples = 200;
  CHECK(test::measuredCloudiness(carpet, kSamples) > 0.2);
  CHECK(test::measuredCloudiness(flat, kSamples) < 0.11);
}

TEST_CASE("Auto takes a gradient and a vignette away") {
  for (const auto& generate : {exemplars::slopingLight, exemplars::vignette}) {
    const MapExemplar map = baseColor(generate(128));
    const std::optional<double> period = automaticPeriod(map, false);
    REQUIRE(period.has_value());
    CHECK(scoreOf(map, "low-frequency", false) > 2.0 / 3.0);
    CHECK(scoreOf(flattened(map, *period, false), "low-frequency", false) < 1.0 / 3.0);
  }
}

TEST_CASE("Auto leaves alone what works, and what no period would mend") {
  CHECK_FALSE(automaticPeriod(baseColor(exemplars::granite(256)), true).has_value());
  CHECK_FALSE(automaticPeriod(baseColor(exemplars::rust(256)), true).has_value());
  CHECK_FALSE(automaticPeriod(baseColor(exemplars::weave(128)), true).has_value());
}

TEST_CASE("The maps of a set lose the same share of their sides") {
  const auto wave = [](int side) {
    return slopes(side, side, [side](int x, int) { return 0.1 * std::cos(kTurn * 2 * x / side); });
  };
  std::vector<MapExemplar> maps{wave(64), wave(32)};
  REQUIRE(flatten(maps, 32.0, true).ok());
  CHECK(amplitude(maps[0], 2) == Approx(0.05).epsilon(1e-4));
  CHECK(amplitude(maps[1], 2) == Approx(0.05).epsilon(1e-4));
}

TEST_CASE("Maps of any size and content are flattened to finite values in range") {
  const auto check = [](const MapExemplar& map) {
    for (const bool periodic : {true, false})
      for (const float value : flattened(map, 4.0, periodic).values) {
        CHECK(value >= 0.0f);
        CHECK(value <= 1.0f);
      }
  };
  check(test::threeMaterials(1, 1, 1));
  check(test::threeMaterials(1, 23, 1));
  check(test::threeMaterials(31, 17, 1));
  MapExemplar black = test::threeMaterials(8, 8, 1);
  std::fill(black.values.begin(), black.values.end(), 0.0f);
  CHECK(flattened(black, 4.0).values == black.values);
  CHECK_FALSE(automaticPeriod(black, true).has_value());
}

TEST_CASE("Data stay within their range, and opacity stays as it is") {
  MapExemplar map;
  map.channels = {MapChannel::height};
  map.target = MapTarget::height;
  map.encoding = ValueEncoding::linear;
  map.width = map.height = 64;
  // A bar of 1 on 0, around which a high-pass undershoots by a quarter.
  for (int i = 0; i < 64 * 64; ++i)
    map.values.push_back(i % 64 < 16 ? 1.0f : 0.0f);
  const MapExemplar flat = flattened(map, 32.0);
  const auto [least, most] = std::minmax_element(flat.values.begin(), flat.values.end());
  CHECK(*least == 0.0f);
  CHECK(*most <= 1.0f);
  CHECK(flat.values != map.values);
  map.target = MapTarget::opacity;
  map.channels = {MapChannel::opacity};
  CHECK(flattened(map, 32.0).values == map.values);
}

TEST_CASE("A period or a map out of range is refused by name") {
  std::vector<MapExemplar> maps{test::threeMaterials(8, 8, 1)};
  for (const double period : {3.9, 16385.0, std::numeric_limits<double>::quiet_NaN()}) {
    const Result<void> result = flatten(maps, period, true);
    REQUIRE_FALSE(result.ok());
    CHECK(result.error().kind == ErrorKind::usage);
    CHECK(result.error().message.find("4 to 16384") != std::string::npos);
  }
  CHECK_FALSE(flatten({}, 64.0, true).ok());
  maps.front().values.pop_back();
  CHECK_FALSE(flatten(maps, 64.0, true).ok());
  CHECK_FALSE(flatteningPeriod(maps.front(), true).ok());
}
