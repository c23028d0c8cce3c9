// SPDX-License-Identifier: MIT
// What flattening removes and preserves, measured by waves and spectra.
#include "base_color.h"
#include "example_exemplar.h"
#include "generated_exemplar.h"
#include "statistics_of_maps.h"

#include <lichen/exemplar_repair.h>
#include <lichen/lattice.h>
#include <lichen/spectrum.h>
#include <lichen/suitability.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <map>
#include <materials.h>
#include <numbers>
#include <photographs.h>
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

/// The map without uneven light, if there was any.
std::optional<MapExemplar> withoutLight(MapExemplar map, bool periodic) {
  const std::vector<float> before = map.values;
  const Result<std::optional<RemovedLight>> light = removeUnevenLight(map, periodic);
  REQUIRE(light.ok());
  if (light.value())
    return map;
  CHECK(map.values == before);
  return std::nullopt;
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
      sum += 0.1 * std::sin(kTurn * cycles * (x + 0.5) / kWidth); // odd about the middle: no trend
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

TEST_CASE("flatten removes every polynomial of degree 4 from an exemplar that does not tile") {
  const auto quartic = [](int x, int y) {
    const double u = x / 32.0 - 1.0, v = y / 25.0 - 0.8;
    return 0.3 + u - 0.5 * v + u * v + 0.7 * u * u - v * v * v + 0.4 * u * u * v * v -
           0.2 * u * u * u * u;
  };
  const MapExemplar map = slopes(64, 50, quartic);
  const MapExemplar flat = flattened(map, 16.0, false);
  const double mean = amplitude(map, 0);
  for (std::size_t i = 0; i < flat.values.size(); i += 2)
    CHECK(double(flat.values[i]) == Approx(mean).margin(1e-5)); // float rounding of values up to 3
}

TEST_CASE("beside its trend, an exemplar is mirrored at its borders") {
  constexpr int kSide = 128;
  // Half waves are whole waves of the mirrored row. They are so short that their trend is less than
  // 1 % of them: the projection on 1, x, ... x^4 of a cosine of 25 half waves.
  constexpr int kHalfWaves = 25;
  const auto wave = [](int x, int) {
    return std::cos(0.5 * kTurn * kHalfWaves * (x + 0.5) / kSide);
  };
  const MapExemplar map = slopes(kSide, kSide, wave);
  const double period = 2.0 * kSide / kHalfWaves; // the wave's: half remains
  const MapExemplar flat = flattened(map, period, false);
  for (int x = 0; x < kSide; ++x) {
    INFO(x);
    CHECK(double(flat.values[std::size_t(2 * x)]) == Approx(0.5 * wave(x, 0)).margin(0.02));
  }
}

TEST_CASE("flatten divides by uneven light, and the result matches even light") {
  const MapExemplar lit = generatedExemplar(exemplars::slopingLight, 128);
  const MapExemplar even = generatedExemplar(exemplars::sand, 128);
  const MapExemplar flatLit = flattened(lit, 128.0, false);
  const MapExemplar flatEven = flattened(even, 128.0, false);
  // Clipped highlights and rounding to 8 bits remain.
  const double left = rootMeanSquare(flatLit.values, flatEven.values);
  INFO(left / rootMeanSquare(lit.values, even.values));
  CHECK(left < 0.15 * rootMeanSquare(lit.values, even.values));
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

namespace {

/// Natural logarithm of the light of 8 x 8 parts of an image, mean over the channels.
std::vector<double> lightOfParts(const std::vector<float>& codes, int side) {
  constexpr int kParts = 8;
  std::vector<double> light(kParts * kParts);
  for (int i = 0; i < 3 * side * side; ++i) {
    const int x = i / 3 % side, y = i / 3 / side;
    light[std::size_t(y * kParts / side * kParts + x * kParts / side)] +=
        double(srgbToLinear(codes[std::size_t(i)]));
  }
  for (double& value : light)
    value = std::log(value);
  return light;
}

constexpr int kSurfaceSide = 256;

/// Standard deviation of the light of `lit` over the light of `even`, both of the same material.
double unevenness(const std::vector<float>& lit, const std::vector<float>& even, int side) {
  std::vector<double> ratio = lightOfParts(lit, side);
  const std::vector<double> material = lightOfParts(even, side);
  for (std::size_t i = 0; i < ratio.size(); ++i)
    ratio[i] -= material[i];
  return std::sqrt(test::covarianceOf(ratio, ratio));
}

/// A material under even light, as one photographs it. To generate it takes longer than the tests.
const SrgbImage& surfaceOf(const std::string& material) {
  static std::map<std::string, SrgbImage> all;
  const auto found = all.find(material);
  return found != all.end()
             ? found->second
             : all.emplace(material, exemplars::photographedSurface(material, kSurfaceSide))
                   .first->second;
}

} // namespace

TEST_CASE("light that shows on fine surfaces is removed, and even surfaces are left as they are",
          "[large]") {
  constexpr int kSide = kSurfaceSide;
  constexpr float kShows = 0.25f; // the share of light that is missing where it is darkest
  using exemplars::Fault;
  for (const char* material : {"moss", "plaster", "cloth", "concrete", "granite", "sand"}) {
    const SrgbImage& surface = surfaceOf(material);
    const bool isFine = material != std::string("granite") && material != std::string("sand");
    for (const exemplars::PhotographPlan& plan : exemplars::sixtyPhotographs()) {
      const bool isLit = plan.fault == Fault::vignette || plan.fault == Fault::gradient ||
                         plan.fault == Fault::shadow;
      if (plan.material != std::string(material) || !(isLit || plan.fault == Fault::none))
        continue;
      const exemplars::Photograph photograph = exemplars::photograph(surface, plan);
      MapExemplar map = baseColor(photograph.image);
      const Result<std::optional<RemovedLight>> light = removeUnevenLight(map, false);
      REQUIRE(light.ok());
      const double before = unevenness(photograph.image.values, photograph.even.values, kSide);
      const double after = unevenness(map.values, photograph.even.values, kSide);
      INFO(plan.name() << ": unevenness " << before << ", then " << after);
      if (plan.fault == Fault::none)
        CHECK_FALSE(light.value().has_value());
      if (isFine && plan.strength > kShows) {
        CHECK(light.value().has_value());
        CHECK(after < 0.35 * before); // 0.30 for the shadow on moss, 0.15 at most for the others
      }
      if (light.value()) {
        CHECK(light.value()->darkest < 1.0 - 0.3 * plan.strength);
        CHECK(light.value()->brightest > 1.0);
        CHECK(flattened(baseColor(photograph.image), light.value()->periodPixels, false).values ==
              map.values);
      }
    }
  }
}

TEST_CASE("patches of another colour are the material's own") {
  constexpr int kSide = kSurfaceSide;
  for (const char* material : {"plaster", "concrete", "cloth"}) {
    const exemplars::Photograph photograph =
        exemplars::photograph(surfaceOf(material), {material, exemplars::Fault::patches, 0.45f, 7});
    MapExemplar map = baseColor(photograph.image);
    REQUIRE(removeUnevenLight(map, false).ok());
    const double before = unevenness(photograph.image.values, photograph.even.values, kSide);
    const double after = unevenness(map.values, photograph.even.values, kSide);
    INFO(material << ": unevenness " << before << ", then " << after);
    CHECK(after > 0.7 * before);
  }
}

TEST_CASE("without uneven light, no risk of low frequency is left") {
  for (const auto generate : {exemplars::slopingLight, exemplars::vignette}) {
    const MapExemplar map = generatedExemplar(generate, 128);
    CHECK(scoreOf(map, "low-frequency", false) > 2.0 / 3.0);
    const std::optional<MapExemplar> flat = withoutLight(map, false);
    REQUIRE(flat.has_value());
    CHECK(scoreOf(*flat, "low-frequency", false) < 1.0 / 3.0);
  }
}

TEST_CASE("a vignette is removed from an image that tiles; other slow variation is its own") {
  CHECK(withoutLight(generatedExemplar(exemplars::vignette, 256), true).has_value());
  for (const exemplars::Material& material : exemplars::kMaterials)
    CHECK_FALSE(withoutLight(generatedExemplar(material.generate, 128), true).has_value());
  CHECK_FALSE(withoutLight(generatedExemplar(exemplars::carpet, 128), true).has_value());
  CHECK_FALSE(withoutLight(generatedExemplar(exemplars::weave, 128), true).has_value());
}

TEST_CASE("an object keeps its brightness, because its outline would remain") {
  for (const int side : {128, 256})
    for (const bool periodic : {true, false})
      CHECK_FALSE(withoutLight(baseColor(exemplars::oneStone(side)), periodic).has_value());
}

TEST_CASE("the maps of a set are flattened at the same fraction of their sides") {
  const auto wave = [](int side) {
    return slopes(side, side,
                  [side](int x, int) { return 0.1 * std::sin(kTurn * 2 * (x + 0.5) / side); });
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
  CHECK_FALSE(withoutLight(black, false).has_value());
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
  CHECK_FALSE(removeUnevenLight(maps.front(), false).ok());
}
