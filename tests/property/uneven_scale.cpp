// SPDX-License-Identifier: MIT
// Ground seen at a slant is found, and by about the same amount from 256 to 512 pixels.
#include "base_color.h"

#include <lichen/suitability.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <exemplar/resample.h>
#include <materials.h>
#include <string_view>
#include <suitability/picture_measures.h>
#include <suitability/risk_of.h>

using namespace lichen;
using namespace lichen::suitability;
using lichen::test::baseColor;

namespace {

constexpr int kSide = 512, kGroundSide = 256; // pixels

/// The ground in perspective, `ratio` times as wide at the bottom as at the top, where each pixel
/// is the mean of kSamples x kSamples.
MapExemplar slanted(const SrgbImage& ground, double ratio) {
  constexpr int kSamples = 5;
  const auto groundAt = [&](double x, double y) {
    const auto wrapped = [](double at) {
      return (int(std::floor(at)) % kGroundSide + kGroundSide) % kGroundSide;
    };
    return ground.pixel(wrapped(x), wrapped(y));
  };
  SrgbImage image(kSide, kSide, 3);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      std::array<float, 3> sum{};
      for (int k = 0; k < kSamples * kSamples; ++k) {
        const double u = (x + (k % kSamples + 0.5) / kSamples) / kSide - 0.5;
        const double v = (y + (k / kSamples + 0.5) / kSamples) / kSide;
        const double width = 1.0 / ratio + (1.0 - 1.0 / ratio) * v; // 1 at the bottom
        const double ahead = (1.0 - v) / width;
        const float* const color = groundAt(kSide * u / width, kSide * ahead);
        for (std::size_t c = 0; c < sum.size(); ++c)
          sum[c] += color[c];
      }
      for (std::size_t c = 0; c < sum.size(); ++c)
        image.pixel(x, y)[c] = std::round(255.0f * sum[c] / float(kSamples * kSamples)) / 255.0f;
    }
  return baseColor(image);
}

double at(const MapExemplar& map, int width, int height) {
  return unevenScale(exemplar::resampled(map, width, height, false));
}

} // namespace

TEST_CASE("ground at a slant has the same uneven scale at all sides from 256 to 512 pixels") {
  // A quarter of the mild threshold. A square of 2 pixels blurs a little less than the same square
  // around every pixel, so the largest step, 0.17 octaves, is from 511 to 512.
  constexpr double kOctaves = 0.2;
  for (const exemplars::Material& material : exemplars::kMaterials) {
    const SrgbImage ground = material.generate(kGroundSide);
    const MapExemplar even = slanted(ground, 1.0), slant = slanted(ground, 3.0);
    const double least = at(slant, 256, 256);
    for (const int side : {256, 384, 511, 512}) {
      INFO(material.name << ", " << side);
      CHECK(at(slant, side, side) == Approx(least).margin(kOctaves));
      CHECK(at(even, side, side) < 0.5 * kUnevenScale.mild);
      if (material.name != std::string_view("lichen_on_stone")) // as soft from near as from far
        CHECK(at(slant, side, side) > kUnevenScale.mild);
    }
    for (const MapExemplar* map : {&even, &slant}) {
      const Risk risk = assessSuitability(*map, false).value().back();
      REQUIRE(risk.name == "uneven-scale");
      CHECK((risk.level != Risk::Level::none) == (unevenScale(*map) > kUnevenScale.mild));
    }
  }
}

TEST_CASE("the uneven scale of a turned picture is the same") {
  const MapExemplar down = slanted(exemplars::granite(kGroundSide), 3.0);
  MapExemplar across = down;
  for (std::size_t y = 0; y < kSide; ++y)
    for (std::size_t x = 0; x < kSide; ++x)
      std::copy_n(&down.values[3 * (y * kSide + x)], 3, &across.values[3 * (x * kSide + y)]);
  for (const int side : {300, kSide})
    CHECK(at(across, side, side) == Approx(at(down, side, side)).epsilon(1e-4));
}

TEST_CASE("an uneven scale is measured from 128 pixels of the shorter side on") {
  const MapExemplar slant = slanted(exemplars::granite(kGroundSide), 3.0);
  CHECK(at(slant, 127, 127) == 0.0);
  CHECK(at(slant, 127, kSide) == 0.0);
  CHECK(at(slant, kSide, 127) == 0.0);
  // So small a picture has lost the finest detail, which differs most.
  CHECK(at(slant, 128, 128) > 0.5 * kUnevenScale.mild);
  CHECK(at(slant, 128, kSide) > 0.5 * kUnevenScale.mild);
  MapExemplar data = slant;
  data.target = MapTarget::emissive;
  CHECK(unevenScale(data) == 0.0);
}
