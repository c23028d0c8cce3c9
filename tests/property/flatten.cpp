// SPDX-License-Identifier: MIT
// What flattening removes and preserves, measured by waves, spectra and the remaining cloudiness.
#include "example_exemplar.h"
#include "generated_exemplar.h"
#include "measured_cloudiness.h"

#include <lichen/fft.h>
#include <lichen/flatten.h>
#include <lichen/lattice.h>
#include <lichen/spectrum.h>
#include <lichen/suitability.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <materials.h>
#include <numbers>
#include <periodic.h>
#include <suitability/cloudiness.h>
#include <suitability/gaussian_plane.h>
#include <unsuitable.h>

using namespace lichen;
using lichen::test::baseColor;
using lichen::test::generatedExemplar;

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// Two slopes per pixel; the second is zero.
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

/// Amplitude of the wave with `cycles` cycles across the map, in the first channel.
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

FlatteningChoice automatic(MapExemplar map, bool periodic) {
  Result<FlatteningChoice> choice = flattenAutomatically({&map, 1}, periodic);
  REQUIRE(choice.ok());
  return std::move(choice).value();
}

std::optional<double> automaticPeriod(const MapExemplar& map, bool periodic) {
  return automatic(map, periodic).periodPixels;
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

TEST_CASE("flatten halves waves of the period, preserves shorter ones and the mean, and removes "
          "longer ones") {
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

TEST_CASE("flatten extends an exemplar by mirroring, or by wrapping if it tiles") {
  constexpr int kSide = 64;
  const MapExemplar ramp = slopes(kSide, kSide, [](int x, int) { return double(x) / kSide; });
  // The first pixel of a filtered row of `period` pixels, as the sum over its frequencies. The gain
  // is 1 - 2^-(cycles per period)^2 with a period of half a side.
  const auto filteredStart = [](int period, const auto& valueAt) {
    double start = 0.0;
    for (int cycles = 1 - period / 2; cycles <= period / 2; ++cycles) {
      std::complex<double> sum = 0.0;
      for (int x = 0; x < period; ++x)
        sum += valueAt(x) * std::polar(1.0, -kTurn * cycles * x / period);
      const double perPeriod = 0.5 * kSide * cycles / period;
      start += sum.real() / period * (1.0 - std::exp2(-perPeriod * perPeriod));
    }
    return start;
  };
  const double mean = 0.5 * double(kSide - 1) / kSide;
  const auto start = [&](bool periodic) {
    return double(flattened(ramp, kSide / 2.0, periodic).values[0]) - mean;
  };
  const auto rampAt = [](int x) { return double(x) / kSide; };
  const auto mirroredAt = [&](int x) { return rampAt(x < kSide ? x : 2 * kSide - 1 - x); };
  const double mirrored = filteredStart(2 * kSide, mirroredAt);
  const double repeated = filteredStart(kSide, rampAt);
  // Float transforms have an error of about 1e-7 of the plane's values, twice.
  CHECK(start(false) == Approx(mirrored).margin(1e-6));
  CHECK(start(true) == Approx(repeated).margin(1e-6));
  // The jump of 1 at the border remains as a step of nearly 1/2 on each side.
  CHECK(std::abs(mirrored) < 0.25 * std::abs(repeated));
}

TEST_CASE("flatten divides by uneven light, and the result matches even light") {
  const MapExemplar lit = generatedExemplar(exemplars::slopingLight, 128);
  const MapExemplar even = generatedExemplar(exemplars::sand, 128);
  const MapExemplar flatLit = flattened(lit, 128.0, false);
  const MapExemplar flatEven = flattened(even, 128.0, false);
  // Periodic treatment of the slope's border, clipped highlights and rounding to 8 bits leave 0.28.
  CHECK(rootMeanSquare(flatLit.values, flatEven.values) <
        0.35 * rootMeanSquare(lit.values, even.values));
  double before = 0.0, after = 0.0;
  for (std::size_t i = 0; i < lit.values.size(); ++i) {
    before += double(srgbToLinear(lit.values[i]));
    after += double(srgbToLinear(flatLit.values[i]));
  }
  CHECK(after == Approx(before).epsilon(0.01)); // except for clipped highlights
}

TEST_CASE("flatten preserves detail faster than the period") {
  const MapExemplar carpet = generatedExemplar(exemplars::carpet, 128);
  const MapExemplar flat = flattened(carpet, 64.0);
  const auto power = [](const MapExemplar& map) {
    return radialPowerSpectrum(luminancePlane(imageOf(map)), map.width, map.height, 64);
  };
  const std::vector<double> before = power(carpet), after = power(flat);
  // From 4 cycles per period on, the filter keeps all but 2^-16. The factor that brightens dark
  // areas moves power between frequencies: up to 6 %.
  for (std::size_t ring = 4; ring < before.size(); ++ring) {
    INFO("ring " << ring);
    CHECK(after[ring] == Approx(before[ring]).epsilon(0.1));
  }
}

TEST_CASE("auto flattens a cloudy exemplar no more than necessary") {
  const MapExemplar carpet = generatedExemplar(exemplars::carpet, 128);
  const std::optional<double> period = automaticPeriod(carpet, true);
  REQUIRE(period.has_value());
  const MapExemplar flat = flattened(carpet, *period);
  for (const std::string_view name : {"cloudiness", "low-frequency"})
    CHECK(scoreOf(flat, name, true) < 1.0 / 3.0);
  const auto patches = [](const MapExemplar& map) {
    const auto plane = suitability::gaussianPlane(map, true);
    REQUIRE(plane.has_value());
    return suitability::patchShare(forwardFft(plane->values, plane->width, plane->height));
  };
  CHECK(patches(flat) < 0.01);
  CHECK(patches(flattened(carpet, std::numbers::sqrt2 * *period)) >= 0.01);
  // As measured on the decoded noise: from about 0.27 to 0.1 or less.
  constexpr int kSamples = 200;
  CHECK(test::measuredCloudiness(carpet, kSamples) > 0.2);
  CHECK(test::measuredCloudiness(flat, kSamples) < 0.11);
}

TEST_CASE("auto removes a gradient and a vignette") {
  for (const auto& generate : {exemplars::slopingLight, exemplars::vignette}) {
    const MapExemplar map = generatedExemplar(generate, 128);
    const std::optional<double> period = automaticPeriod(map, false);
    REQUIRE(period.has_value());
    CHECK(scoreOf(map, "low-frequency", false) > 2.0 / 3.0);
    CHECK(scoreOf(flattened(map, *period, false), "low-frequency", false) < 1.0 / 3.0);
  }
}

TEST_CASE("auto removes a vignette from fine plaster down to the level of its grain") {
  constexpr int kSide = 256;
  // Grain of 4 % of the light, with no period above 24 pixels.
  const exemplars::Field grain = exemplars::fractalNoise(kSide, {24.0f, 2.0f, 0.7f}, 7);
  const auto plaster = [&](const auto& lightAt) {
    SrgbImage image(kSide, kSide, 3);
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x)
        for (int c = 0; c < 3; ++c)
          image.pixel(x, y)[c] = linearToSrgb(
              (0.5f - 0.05f * float(c)) * (1.0f + 0.04f * grain.at(2 * x, 2 * y)) * lightAt(x, y));
    return baseColor(image);
  };
  const auto vignette = [](int x, int y) {
    const double fromMiddle = std::hypot(x - 0.5 * kSide, y - 0.5 * kSide) / (0.5 * kSide);
    return float(1.0 - 0.2 * fromMiddle * fromMiddle);
  };
  const MapExemplar even = plaster([](int, int) { return 1.0f; });
  const MapExemplar lit = plaster(vignette);
  const std::optional<double> period = automaticPeriod(lit, false);
  REQUIRE(period.has_value());
  const MapExemplar flat = flattened(lit, *period, false);
  std::vector<double> removed, light, clouds, before, after;
  for (int i = 0; i < kSide * kSide; ++i) {
    const auto green = std::size_t(3 * i + 1);
    removed.push_back(double(srgbToLinear(lit.values[green]) / srgbToLinear(flat.values[green])));
    light.push_back(double(vignette(i % kSide, i / kSide)));
    clouds.push_back(double(flat.values[green] - even.values[green]));
    before.push_back(double(even.values[green]));
    after.push_back(double(flat.values[green]));
  }
  const double contrast = std::sqrt(test::variance(before));
  // What was removed is the light.
  double together = 0.0;
  for (std::size_t i = 0; i < light.size(); ++i)
    together += (removed[i] - test::mean(removed)) * (light[i] - test::mean(light));
  together /= double(light.size()) * std::sqrt(test::variance(removed) * test::variance(light));
  INFO(*period << " pixels: correlation " << together << ", clouds "
               << std::sqrt(test::variance(clouds)) / contrast << ", contrast "
               << std::sqrt(test::variance(after)) / contrast);
  CHECK(together > 0.95);
  // Without a risk, but with visible patches, 0.9 of the contrast would be left.
  CHECK(std::sqrt(test::variance(clouds)) < 0.5 * contrast);
  CHECK(std::sqrt(test::variance(after)) == Approx(contrast).epsilon(0.1));
}

TEST_CASE("auto changes neither an exemplar without risks nor one that no period improves") {
  CHECK_FALSE(automaticPeriod(generatedExemplar(exemplars::granite, 256), true).has_value());
  CHECK_FALSE(automaticPeriod(generatedExemplar(exemplars::rust, 256), true).has_value());
  const FlatteningChoice weave = automatic(generatedExemplar(exemplars::weave, 128), true);
  CHECK(weave.reason == FlatteningChoice::Reason::unresolved);
  CHECK_FALSE(weave.periodPixels.has_value());
}

TEST_CASE("auto leaves an object unchanged, because its outline would remain") {
  for (const int side : {128, 256}) {
    const MapExemplar stone = baseColor(exemplars::oneStone(side));
    MapExemplar map = stone;
    const Result<FlatteningChoice> choice = flattenAutomatically({&map, 1}, true);
    REQUIRE(choice.ok());
    CHECK(choice.value().reason == FlatteningChoice::Reason::object);
    CHECK(choice.value().flattened.empty());
    CHECK(map.values == stone.values);
  }
}

TEST_CASE("auto flattens the colours, and other maps only if they vary slowly") {
  std::vector<MapExemplar> maps{generatedExemplar(exemplars::slopingLight, 128)};
  MapExemplar data;
  data.encoding = ValueEncoding::linear;
  data.width = data.height = 128;
  data.target = MapTarget::occlusionRoughnessMetallic;
  data.channels = {MapChannel::roughness};
  const auto add = [&](double slope) {
    data.values.clear();
    for (int i = 0; i < 128 * 128; ++i)
      data.values.push_back(
          float(0.3 + slope * (i % 128) / 128.0 + 0.2 * (pcg(std::uint32_t(i)) * 0x1p-32)));
    maps.push_back(data);
  };
  add(0.0);
  data.target = MapTarget::height;
  data.channels = {MapChannel::height};
  add(0.4); // a tilt, which changes no light
  data.target = MapTarget::emissive;
  data.channels = {MapChannel::red};
  add(0.4);
  const std::vector<MapExemplar> before = maps;
  const Result<FlatteningChoice> choice = flattenAutomatically(maps, false);
  REQUIRE(choice.ok());
  CHECK(choice.value().reason == FlatteningChoice::Reason::flattened);
  CHECK(choice.value().flattened == std::vector{MapTarget::baseColor, MapTarget::emissive});
  CHECK(maps[1].values == before[1].values);
  CHECK(maps[2].values == before[2].values);
  // The remaining light is what the map's own period leaves.
  CHECK(maps[3].values == flattened(before[3], *choice.value().periodPixels, false).values);
}

TEST_CASE("flattening and assessing report their progress, and the caller can stop them") {
  const MapExemplar cloudy = generatedExemplar(exemplars::carpet, 128);
  const auto check = [](const auto& operation, const std::string& message) {
    std::vector<double> fractions;
    REQUIRE(operation([&](double fraction) {
              fractions.push_back(fraction);
              return true;
            }).ok());
    CHECK(fractions.size() > 2);
    CHECK(std::is_sorted(fractions.begin(), fractions.end()));
    CHECK(fractions.front() >= 0.0);
    CHECK(fractions.back() <= 1.0);
    for (std::size_t last = 1; last <= fractions.size(); ++last) {
      std::size_t calls = 0;
      const auto stopped = operation([&](double) { return ++calls < last; });
      REQUIRE_FALSE(stopped.ok());
      CHECK(stopped.error().kind == ErrorKind::environment);
      CHECK(stopped.error().message == message);
      CHECK(calls == last);
    }
  };
  check([&](const Progress& progress) { return assessSuitability(cloudy, true, progress); },
        "the assessment: interrupted");
  const auto withCopy = [&](const auto& operation) {
    return [&, operation](const Progress& progress) {
      MapExemplar map = cloudy;
      return operation(map, progress);
    };
  };
  check(withCopy([](MapExemplar& map, const Progress& progress) {
          return flatten({&map, 1}, 32.0, true, progress);
        }),
        "flattening: interrupted");
  check(withCopy([](MapExemplar& map, const Progress& progress) {
          return flattenAutomatically({&map, 1}, false, progress);
        }),
        "flattening: interrupted");
}

TEST_CASE("the maps of a set are flattened at the same fraction of their sides") {
  const auto wave = [](int side) {
    return slopes(side, side, [side](int x, int) { return 0.1 * std::cos(kTurn * 2 * x / side); });
  };
  std::vector<MapExemplar> maps{wave(64), wave(32)};
  REQUIRE(flatten(maps, 32.0, true).ok());
  CHECK(amplitude(maps[0], 2) == Approx(0.05).epsilon(1e-4));
  CHECK(amplitude(maps[1], 2) == Approx(0.05).epsilon(1e-4));
}

TEST_CASE("flattened values are finite and in range for maps of any size and content") {
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

TEST_CASE("flatten keeps data in range and does not change opacity") {
  MapExemplar map;
  map.channels = {MapChannel::height};
  map.target = MapTarget::height;
  map.encoding = ValueEncoding::linear;
  map.width = map.height = 64;
  // A bar of 1 on 0; a high-pass filter undershoots by a quarter around it.
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

TEST_CASE("the error for a period or a map out of range names it") {
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
  CHECK_FALSE(flattenAutomatically(maps, true).ok());
}
