// SPDX-License-Identifier: MIT
// The risks of exemplars, against closed forms, exhaustive sums, and pictures known to work or
// fail.
#include "base_color.h"
#include "example_exemplar.h"
#include "generated_exemplar.h"
#include "plane_of.h"
#include "statistics_of_maps.h"

#include <lichen/lattice.h>
#include <lichen/quality.h>
#include <lichen/spectrum.h>
#include <lichen/suitability.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <exemplar/low_pass.h>
#include <limits>
#include <materials.h>
#include <numbers>
#include <suitability/color_measures.h>
#include <suitability/gaussian_plane.h>
#include <suitability/picture_measures.h>
#include <suitability/risk_of.h>
#include <suitability/spectral_measures.h>
#include <unsuitable.h>

using namespace lichen;
using namespace lichen::suitability;
using lichen::test::baseColor;
using lichen::test::generatedExemplar;

namespace {

MapExemplar grey(int width, int height, const auto& valueAt) {
  MapExemplar map = test::planeOf(width, height, valueAt);
  map.target = MapTarget::occlusionRoughnessMetallic;
  map.channels = {MapChannel::roughness};
  return map;
}

SrgbImage constant(int width, int height, float level) {
  SrgbImage image(width, height, 3);
  image.values.assign(image.values.size(), level);
  return image;
}

std::vector<Risk> risksOf(const MapExemplar& map, bool periodic = true) {
  const Result<std::vector<Risk>> risks = assessSuitability(map, periodic);
  REQUIRE(risks.ok());
  return risks.value();
}

const Risk& named(const std::vector<Risk>& risks, std::string_view name) {
  for (const Risk& risk : risks)
    if (risk.name == name)
      return risk;
  FAIL("no risk " << name);
  return risks.front();
}

float uniform(int x, int y, std::uint32_t seed) {
  return float(pcg3d({std::uint32_t(x), std::uint32_t(y), seed})[0] >> 8u) * 0x1p-24f;
}

/// Standardized to unit variance from the given value at each pixel.
template <typename ValueAt>
std::vector<float> standardized(int width, int height, const ValueAt& valueAt) {
  std::vector<float> values;
  double sum = 0.0, squares = 0.0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      values.push_back(float(valueAt(x, y)));
      sum += double(values.back());
      squares += double(values.back()) * double(values.back());
    }
  const double count = double(values.size()), mean = sum / count;
  for (float& value : values)
    value = float((double(value) - mean) / std::sqrt(squares / count - mean * mean));
  return values;
}

} // namespace

TEST_CASE("streaks longer than the image do not repeat, stripes at even steps do") {
  constexpr int kSide = 256;
  std::vector<float> streaks, stripes;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const float grain = 0.05f * uniform(x, y, 3);
      float streak = 0.0f; // four columns wide
      for (int k = 0; k < 4; ++k)
        streak += 0.15f * uniform(x + k, 0, 4);
      streaks.push_back(0.1f + streak + grain);
      stripes.push_back((x % 16 < 8 ? 0.3f : 0.6f) + grain);
    }
  const auto linesOf = [](const std::vector<float>& plane) {
    return latticeShare(forwardFft(plane, kSide, kSide));
  };
  CHECK(linesOf(streaks) < kLatticeShare.mild);
  CHECK(linesOf(stripes) > kLatticeShare.severe);
}

TEST_CASE("a small map of a set is assessed at the resolution of the set's texton") {
  // Two waves per side: a period of 32 of the map's own pixels, and of 64 texels of the largest
  // map.
  constexpr int kSide = 64;
  const MapExemplar map = grey(kSide, kSide, [](int x, int) {
    return 0.5 + 0.2 * std::sin(2.0 * std::numbers::pi * 2.0 * x / kSide);
  });
  const auto slow = [&](int texels) {
    const Result<std::vector<Risk>> risks = assessTextonSuitability(map, 40, {}, texels, texels);
    REQUIRE(risks);
    REQUIRE(risks.value().back().name == "low-frequency");
    return risks.value().back();
  };
  CHECK(slow(0).level == Risk::Level::none);
  CHECK(slow(2 * kSide).level == Risk::Level::severe);
  CHECK_THAT(remedyOf(slow(2 * kSide)), Catch::Contains("support 80"));
}

TEST_CASE("outlines in all directions are a severe risk, and random phases have none") {
  // The joints of paving fill the waves of all directions together as Gaussian noise does.
  for (auto* generate : {exemplars::paving, exemplars::terrazzo}) {
    const MapExemplar map = generatedExemplar(generate, 256);
    const std::vector<Risk> risksOfMap = assessTextonSuitability(map, 64).value();
    CHECK(named(risksOfMap, "outlines").level == Risk::Level::severe);
    MapExemplar gaussian = map;
    for (std::size_t c = 0; c < 3; ++c) {
      std::vector<float> plane;
      for (std::size_t i = c; i < map.values.size(); i += 3)
        plane.push_back(map.values[i]);
      const std::vector<float> random =
          phaseRandomizedPlane(forwardFft(plane, map.width, map.height), 1);
      for (std::size_t i = 0; i < random.size(); ++i) // less contrast, to stay in range
        gaussian.values[3 * i + c] = std::clamp(0.4f + 0.1f * random[i], 0.0f, 1.0f);
    }
    // The coarsest of four octaves has the least weight on the scatter but most of the scatter
    // itself. It has some 400 independent values: sqrt(24 / 400) / 4 of its mean is 0.06, and five
    // of these stay below mild.
    const std::vector<Risk> risks = assessTextonSuitability(gaussian, 64).value();
    CHECK(named(risks, "outlines").level == Risk::Level::none);
  }
}

TEST_CASE("suitable exemplars have no severe risk, with a margin", "[large]") {
  for (const exemplars::Material& material : exemplars::kMaterials)
    for (const Risk& risk : risksOf(generatedExemplar(material.generate, 256))) {
      INFO(material.name << ", " << risk.name << ": " << risk.score);
      CHECK(risk.level == Risk::Level::none);
      CHECK(risk.score < 0.3);
      CHECK(remedyOf(risk).empty());
      CHECK_FALSE(risk.sentence.empty());
    }
}

TEST_CASE("each unsuitable exemplar has its intended risk, severe with a margin") {
  for (const exemplars::Unsuitable& exemplar : exemplars::kUnsuitable) {
    const std::vector<Risk> risks =
        risksOf(generatedExemplar(exemplar.generate, 256), exemplar.periodic);
    const Risk& risk = named(risks, exemplar.risk);
    INFO(exemplar.name << ", " << risk.name << ": " << risk.score);
    CHECK(risk.level == Risk::Level::severe);
    CHECK(risk.score > 0.7);
    CHECK_FALSE(remedyOf(risk).empty());
  }
}

TEST_CASE("the closed form of cloudiness equals the sum over all offsets") {
  constexpr int kWidth = 9, kHeight = 6;
  const std::vector<float> plane = standardized(kWidth, kHeight, [](int x, int y) {
    return uniform(x, y, 3) + 0.6 * std::sin(2.0 * std::numbers::pi * x / kWidth);
  });
  const auto at = [&](int x, int y) {
    return double(plane[std::size_t((y % kHeight) * kWidth + x % kWidth)]);
  };
  std::vector<double> variances;
  for (int b = 0; b < kWidth * kHeight; ++b)
    for (int c = 0; c < kWidth * kHeight; ++c) {
      std::vector<double> blend;
      for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
          blend.push_back(
              (at(x, y) + at(x + b % kWidth, y + b / kWidth) + at(x + c % kWidth, y + c / kWidth)) /
              std::sqrt(3.0));
      variances.push_back(test::covarianceOf(blend, blend));
    }
  CHECK(test::meanOf(variances) == Approx(1.0).epsilon(1e-5)); // preserved on average
  CHECK(
      cloudiness(forwardFft(plane, kWidth, kHeight)) ==
      Approx(std::sqrt(test::covarianceOf(variances, variances))).epsilon(1e-5)); // float rounding
}

TEST_CASE("the extension of an exemplar that does not tile is continuous across its borders") {
  constexpr int kSide = 64;
  const MapExemplar ramp = grey(kSide, kSide, [](int x, int) { return double(x) / kSide; });
  const auto jump = [&](bool periodic) {
    const std::optional<GaussianPlane> plane = gaussianPlane(ramp, {periodic});
    REQUIRE(plane.has_value());
    double sum = 0.0;
    for (int y = 0; y < kSide; ++y) {
      const float* row = &plane->values[std::size_t(y) * kSide];
      sum += std::abs(double(row[0]) - double(row[kSide - 1])) / kSide;
    }
    return sum;
  };
  CHECK(jump(true) > 4.0); // more than two standard deviations each
  CHECK(jump(false) < 1.0);
}

TEST_CASE("a wave's share of the variance is its lattice score, at any size") {
  for (const auto& [width, height] : {std::array{128, 128}, std::array{97, 64}}) {
    // Noise of variance 1/12 and a wave of variance 1/12: half each.
    const std::vector<float> plane = standardized(width, height, [width = width](int x, int y) {
      return uniform(x, y, 4) +
             std::sqrt(1.0 / 6.0) * std::cos(2.0 * std::numbers::pi * 11 * x / width);
    });
    // The noise's variance is uncertain by 1 %, and the wave's by the noise at its own frequency.
    CHECK(latticeShare(forwardFft(plane, width, height)) == Approx(0.5).margin(0.02));
  }
}

TEST_CASE("noise has no lattice") {
  // Chance produces 0.13 lines in 16 images of 8192 frequencies; the test allows two.
  double lines = 0.0;
  for (std::uint32_t seed = 0; seed < 16; ++seed) {
    const std::vector<float> plane =
        standardized(128, 128, [&](int x, int y) { return uniform(x, y, 100 + seed); });
    lines += latticeShare(forwardFft(plane, 128, 128));
  }
  constexpr double kLine = 30.0 / 8192.0; // share of a strong line
  CHECK(lines < 2.0 * kLine);
}

TEST_CASE("slow variation counts a ramp and a slow wave, and no faster wave") {
  constexpr int kWidth = 96, kHeight = 64;
  const auto slow = [](const auto& valueAt) {
    return slowVariation(grey(kWidth, kHeight, [&](int x, int y) {
      return valueAt((x + 0.5) / kWidth, (y + 0.5) / kHeight);
    }));
  };
  const double turn = 2.0 * std::numbers::pi;
  // A ramp of height 1: its wave of one cycle has amplitude 1 / pi and variance 1 / (2 pi^2).
  CHECK(slow([](double x, double) { return x; }) ==
        Approx(std::sqrt(0.5) / std::numbers::pi).epsilon(1e-3));
  CHECK(slow([&](double x, double y) { return 0.3 * std::sin(turn * (x - y)); }) ==
        Approx(0.3 * std::sqrt(0.5)).epsilon(1e-5));
  CHECK(slow([&](double x, double) { return 0.5 + 0.3 * std::sin(2.0 * turn * x); }) < 1e-6);
}

TEST_CASE("white and black pixels count only if they mean lost detail") {
  MapExemplar map = baseColor(exemplars::sand(64));
  for (float& value : map.values)
    value = std::clamp(value, 0.1f, 0.9f);
  const auto paint = [&](std::size_t pixel, float value) {
    std::fill_n(map.values.begin() + std::ptrdiff_t(3 * pixel), 3, value);
  };
  for (std::size_t pixel = 0; pixel < 1024; ++pixel)
    paint(pixel, 1.0f);
  for (std::size_t pixel = 1024; pixel < 1536; ++pixel)
    paint(pixel, 0.0f);
  map.values[3 * 2000] = 1.0f; // in one channel only
  CHECK(clippedShare(map).white == 1024.0 / 4096.0);
  CHECK(clippedShare(map).black == 512.0 / 4096.0);
  CHECK(named(risksOf(map), "clipping").level == Risk::Level::severe);
  map.target = MapTarget::emissive;
  CHECK(named(risksOf(map), "clipping").score == 0.0);
}

TEST_CASE("the spacing of codes follows their distribution, and few colours are counted") {
  constexpr int kSide = 64, kPixels = kSide * kSide;
  // n levels k / n of equal frequency, 255 / n codes apart: entropy ln n, and the standard
  // deviation of n points at that spacing on a line, sqrt((n^2 - 1) / 12).
  for (const int n : {2, 4, 8, 16}) {
    INFO(n << " levels");
    SrgbImage image = constant(kSide, kSide, 0.0f);
    for (std::size_t i = 0; i < kPixels; ++i)
      for (std::size_t c = 0; c < 3; ++c)
        image.values[3 * i + c] = float(255 / n * (int(i) % n)) / 255.0f;
    const FewColors few = fewColors(baseColor(image));
    const double deviation = (255 / n) * std::sqrt((n * n - 1) / 12.0);
    const double spacing =
        std::sqrt(2.0 * std::numbers::pi * std::numbers::e) * deviation / double(n);
    CHECK(few.spacing == Approx(spacing));
    CHECK(few.count == Approx(spacing < 10.0 ? 0.0 : n));
  }
  SrgbImage colors = constant(kSide, kSide, 0.0f); // one channel uses all codes, as in a photograph
  for (std::size_t i = 0; i < kPixels; ++i) {
    colors.values[3 * i] = float(i % 2);
    colors.values[3 * i + 1] = float(i % 256) / 255.0f;
  }
  // A uniform distribution: sqrt(2 pi e / 12), up to the steps of 1 / 256.
  CHECK(fewColors(baseColor(colors)).spacing ==
        Approx(std::sqrt(std::numbers::pi * std::numbers::e / 6.0)).epsilon(1e-4));
  CHECK(fewColors(baseColor(constant(8, 8, 1.0f))).spacing == 0.0);
  // Data may be 0 or 1.
  CHECK(fewColors(grey(2, 1, [](int x, int) { return x; })).spacing == 0.0);
}

TEST_CASE("maps of any size and content have all risks, in order, with scores in [0, 1]") {
  const auto check = [](const MapExemplar& map) {
    for (const bool periodic : {true, false}) {
      const std::vector<Risk> risks = risksOf(map, periodic);
      REQUIRE(risks.size() == 5);
      CHECK(risks[0].name == "cloudiness");
      CHECK(risks[1].name == "structure");
      CHECK(risks[2].name == "low-frequency");
      CHECK(risks[3].name == "clipping");
      CHECK(risks[4].name == "uneven-scale");
      for (const Risk& risk : risks) {
        CHECK(risk.score >= 0.0);
        CHECK(risk.score <= 1.0);
      }
    }
  };
  check(grey(1, 1, [](int, int) { return 0.5; }));
  check(grey(1, 300, [](int, int) { return 0.5; }));
  check(grey(3, 2, [](int x, int y) { return (x + y) % 2; }));
  check(grey(1, 5, [](int, int y) { return y < 4 ? y % 2 : 0.5; }));
  check(test::threeMaterials(37, 131, 1));
  check(test::threeMaterials(129, 128, 1));
}

TEST_CASE("a map that does not vary has no risk") {
  for (const float level : {0.0f, 0.5f, 1.0f})
    for (const Risk& risk : risksOf(baseColor(constant(64, 64, level))))
      CHECK(risk.score < 1e-6);
}

TEST_CASE("the error for an invalid map says what is invalid") {
  const Result<std::vector<Risk>> risks = assessSuitability(
      grey(2, 1,
           [](int x, int) { return x == 0 ? 0.0 : std::numeric_limits<double>::quiet_NaN(); }),
      true);
  REQUIRE_FALSE(risks.ok());
  CHECK(risks.error().kind == ErrorKind::usage);
  CHECK(risks.error().message.find("nan") != std::string::npos);
}

TEST_CASE("a height map has the cloudiness and low frequency of its slopes") {
  constexpr int kSide = 64;
  constexpr double kTurn = 2.0 * std::numbers::pi;
  // A slow wave that would be a risk for other data, and a fast one with nearly all the slope.
  MapExemplar height = grey(kSide, kSide, [](int x, int y) {
    return 0.5 + 0.06 * std::sin(kTurn * x / kSide) + 0.1 * std::sin(kTurn * 23 * y / kSide);
  });
  height.target = MapTarget::height;
  height.channels = {MapChannel::height};
  height.quantum = 1.0 / 65535.0;
  MapExemplar normal = height;
  normal.target = MapTarget::normal;
  normal.channels = {MapChannel::slopeX, MapChannel::slopeY};
  normal.encoding = ValueEncoding::slope;
  normal.values.clear();
  // Half the difference of neighbours multiplies a wave of k cycles by sin(2 pi k / side). Slopes
  // are scaled to standard deviations of 0.27, in the mean square of both.
  const double slow = 0.06 * std::sin(kTurn / kSide), fast = 0.1 * std::sin(kTurn * 23 / kSide);
  const double scale = 0.27 / std::sqrt(0.25 * (slow * slow + fast * fast));
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      normal.values.push_back(float(scale * slow * std::cos(kTurn * x / kSide)));
      normal.values.push_back(float(-scale * fast * std::cos(kTurn * 23 * y / kSide)));
    }
  const MapExemplar slopes = slopesOfHeight(height, true);
  double worst = 0.0;
  for (std::size_t i = 0; i < slopes.values.size(); ++i)
    worst = std::max(worst, std::abs(double(slopes.values[i]) - double(normal.values[i])));
  CHECK(worst < scale * 0x1p-23); // two roundings of heights below 1
  const std::vector<Risk> seen = risksOf(height), wanted = risksOf(normal);
  CHECK(named(seen, "low-frequency").score ==
        Approx(named(wanted, "low-frequency").score).epsilon(1e-4));
  CHECK(named(seen, "low-frequency").level == Risk::Level::none);
  MapExemplar data = height;
  data.target = MapTarget::occlusionRoughnessMetallic;
  data.channels = {MapChannel::roughness};
  CHECK(named(risksOf(data), "low-frequency").level != Risk::Level::none);
}

TEST_CASE("slopes of heights above 1 are computed from heights, not logarithms") {
  constexpr int kSide = 32;
  constexpr float kHighest = 63.0f; // 6 as log2(1 + height)
  MapExemplar height = grey(kSide, kSide, [](int x, int y) { return uniform(x, y, 3); });
  height.target = MapTarget::height;
  height.channels = {MapChannel::height};
  MapExemplar logarithm = height;
  logarithm.encoding = ValueEncoding::log2;
  for (float& value : logarithm.values)
    value = std::log2(1.0f + kHighest * value);
  // Codes below 8 are rounded by 2^-22, 1 + height by that times ln 2 and by 2^-23 of its own. Half
  // the difference of two heights is off by no more than one height. The scales may add the same
  // share again.
  const double rounding = (kHighest + 1.0) * (std::numbers::ln2 * 0x1p-22 + 0x1p-23);
  for (const bool periodic : {true, false}) {
    const MapExemplar wanted = slopesOfHeight(height, periodic);
    const MapExemplar found = slopesOfHeight(logarithm, periodic);
    double worst = 0.0, steepest = 0.0;
    for (std::size_t i = 0; i < wanted.values.size(); ++i) {
      worst = std::max(worst, std::abs(double(found.values[i]) - double(wanted.values[i])));
      steepest = std::max(steepest, std::abs(double(wanted.values[i])));
    }
    // The steepest slope is 1/2 the range, or the whole range at a border.
    CHECK(worst < 4.0 * steepest * rounding / kHighest);
  }
}

TEST_CASE("the concentration of slow gradients matches the closed forms of waves, and detects an "
          "object") {
  constexpr int kSide = 64;
  const auto of = [](const auto& valueAt, bool periodic) {
    return exemplar::edgeConcentration(grey(kSide, kSide, valueAt), periodic);
  };
  const auto wave = [](int at) { return 0.2 * std::sin(2.0 * std::numbers::pi * at / kSide); };
  // The mean of cos^4 over the squared mean of cos^2: 3/8 / 1/4; for two crossed waves, 5/4. The
  // last differences are left out: at most 1/63 of a period.
  CHECK(of([&](int x, int) { return wave(x); }, true) == Approx(1.5).epsilon(2.0 / 63.0));
  CHECK(of([&](int x, int y) { return wave(x) + wave(y); }, true) ==
        Approx(1.25).epsilon(2.0 / 63.0));
  CHECK(of([](int, int) { return 0.5; }, true) == 0.0);
  const auto disc = [](int x, int y) { return std::hypot(x - 32, y - 32) < 20 ? 0.8 : 0.2; };
  CHECK(of(disc, true) > 4.2);
}
