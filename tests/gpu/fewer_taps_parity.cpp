// SPDX-License-Identifier: MIT
// Tiling with fewer taps or table levels in the shader, through the plugin, against the CPU twin.
// tests/property/fewer_taps.cpp tests the twin itself.
#include "plugin_host.h"
#include "shared_device.h"
#include "synthetic_noise.h"

#include <lichen/tiling_evaluate.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <tiling_evaluate.comp.fewest_taps.h>
#include <tiling_evaluate.comp.nearest_level.h>
#include <tiling_evaluate.comp.one_tap.h>
#include <tiling_evaluate.comp.two_taps.h>
#include <tiling_quality.comp.h>
#include <triplanar_evaluate.comp.fewest_taps.h>

using namespace lichen;
using namespace lichen::test;

namespace {

constexpr float kTexels = 64.0f; // texels per side of the exemplar
/// The shaders are compiled with this value: half a texel. The exemplar has independent texels,
/// whose mips differ little beyond that size.
constexpr double kOneTapTiles = 1.0 / 128.0;

/// The input layout of triplanar_evaluate.comp.
struct SpacePoint {
  std::array<float, 4> position{}, gradientX{}, gradientY{}, normal{};
};

/// Points some tiles around the origin with any normal. Footprints range from an eighth of a texel
/// to two tiles, round and up to 32 times as long as wide.
std::vector<SpacePoint> samplePoints(std::size_t count) {
  std::mt19937 generator(19u);
  std::uniform_real_distribution<float> tiles(-6.0f, 6.0f), level(-3.0f, 7.0f), slant(0.0f, 5.0f);
  std::normal_distribution<float> gaussian;
  std::vector<SpacePoint> points(count);
  for (SpacePoint& point : points) {
    const float pixel = std::exp2(level(generator)) / kTexels;
    const float narrow = pixel * std::exp2(-slant(generator));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      point.position[axis] = tiles(generator);
      point.normal[axis] = gaussian(generator);
      point.gradientX[axis] = pixel * gaussian(generator);
      point.gradientY[axis] = narrow * gaussian(generator);
    }
  }
  return points;
}

/// Uses the x and y of points in space as texture coordinates.
std::vector<Point> flattened(const std::vector<SpacePoint>& points) {
  std::vector<Point> flat;
  for (const SpacePoint& point : points)
    flat.push_back({{point.position[0], point.position[1]},
                    {point.gradientX[0], point.gradientX[1]},
                    {point.gradientY[0], point.gradientY[1]},
                    {}});
  return flat;
}

TileFootprint footprintOf(const Point& point, const shader::LichenMaterial& m) {
  const auto toTile = [&](const std::array<float, 2>& v) {
    return std::array{m.uvToTileXX * v[0] + m.uvToTileXY * v[1],
                      m.uvToTileYX * v[0] + m.uvToTileYY * v[1]};
  };
  TileFootprint at{toTile(point.uv), toTile(point.gradientX), toTile(point.gradientY)};
  return at;
}

TriplanarFootprint footprintOf(const SpacePoint& point) {
  const auto three = [](const std::array<float, 4>& v) { return std::array{v[0], v[1], v[2]}; };
  return {three(point.position), three(point.gradientX), three(point.gradientY),
          three(point.normal)};
}

/// The fraction of values that differ by more than 1/1024, and the greatest difference.
struct Difference {
  void note(const std::array<float, 4>& found, const TilingEvaluator::Value& expected) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double error = std::abs(double(found[c]) - double(expected[c]));
      largest = std::max(largest, error);
      beyond += error > 1.0 / 1024.0 ? 1 : 0;
      ++count;
    }
  }
  double largest = 0.0;
  int beyond = 0, count = 0;
};

/// A noise on a device, its CPU twin at one quality, and points.
struct OnDevice {
  explicit OnDevice(const TilingQuality& quality)
      : bundle(parseBundle(glb, "synthetic").value()),
        twin(TilingEvaluator::create(bundle, 0, quality).value()), host(sharedContext(), glb) {}
  ~OnDevice() { CHECK(device->messages().texts() == std::vector<std::string>{}); }

  SyntheticMap map{3, int(kTexels), int(kTexels)};
  std::vector<std::byte> glb = syntheticGlb(std::span(&map, 1));
  Bundle bundle;
  TilingEvaluator twin;
  VulkanDevice* device = sharedDevice();
  PluginHost host;
  std::vector<SpacePoint> points = samplePoints(2000);
};

MaterialUse movedAndSharp(const MaterialUse& own) {
  MaterialUse use = moved(own);
  use.parameters.blendSharpness = 2.5;
  return use;
}

} // namespace

TEST_CASE("the shader with fewer taps or table levels matches its CPU twin: 99.9 % within 1/1024 "
          "and all within 1/255") {
  struct Level {
    TilingQuality quality;
    std::span<const std::uint32_t> spirv;
  };
  for (const auto& [quality, spirv] : {Level{{2, 0.0}, tiling_evaluate_comp_two_taps},
                                       Level{{3, kOneTapTiles}, tiling_evaluate_comp_one_tap},
                                       Level{{2, kOneTapTiles}, tiling_evaluate_comp_fewest_taps},
                                       Level{{3, 0.0, true}, tiling_evaluate_comp_nearest_level}}) {
    OnDevice noise(quality);
    const std::vector<Point> points = flattened(noise.points);
    const MaterialUse own = noise.host.use();
    for (const MaterialUse& use : {own, moved(own), movedAndSharp(own)}) {
      const auto values = noise.host.evaluate(spirv, 0, use, points);
      const shader::LichenMaterial& material = noise.host.material();
      Difference difference;
      for (std::size_t k = 0; k < points.size(); ++k)
        difference.note(values[k],
                        noise.twin.evaluate(0, material, footprintOf(points[k], material)));
      INFO(quality.taps << " taps, one from " << quality.oneTapTiles << " tiles, sharpness "
                        << use.parameters.blendSharpness);
      CHECK(difference.largest <= 1.0 / 255.0);
      CHECK(difference.beyond <= 0.001 * difference.count);
    }
  }
}

TEST_CASE("the triplanar shader with fewer taps matches its CPU twin") {
  OnDevice noise({2, kOneTapTiles});
  MaterialUse use = moved(noise.host.use());
  use.parameters.mapping = LICHEN_MAPPING_TRIPLANAR;
  const auto values =
      noise.host.evaluate(triplanar_evaluate_comp_fewest_taps, 0, use, noise.points);
  Difference difference;
  for (std::size_t k = 0; k < noise.points.size(); ++k)
    difference.note(values[k],
                    noise.twin.evaluate(0, noise.host.planes(), footprintOf(noise.points[k])));
  CHECK(difference.largest <= 1.0 / 255.0);
  CHECK(difference.beyond <= 0.001 * difference.count);
}

TEST_CASE("the number of taps has the same effect as a specialization constant and as a macro") {
  OnDevice noise({2, 0.0});
  const std::vector<Point> points = flattened(noise.points);
  const auto equals = [&](int taps, std::span<const std::uint32_t> spirv) {
    const auto values = noise.host.evaluate(tiling_quality_comp, taps, noise.host.use(), points);
    const auto expected = noise.host.evaluate(spirv, 0, noise.host.use(), points);
    Difference difference;
    for (std::size_t k = 0; k < points.size(); ++k)
      difference.note(values[k], expected[k]);
    INFO(taps << " taps");
    CHECK(difference.largest <= 1e-5);
  };
  equals(2, tiling_evaluate_comp_two_taps);
  equals(3, committedShader("tiling_evaluate.comp"));
}

TEST_CASE("the committed shader uses three taps and blends table levels everywhere") {
  // The levels must differ where they should; otherwise the tests above compare nothing.
  OnDevice noise({3, 0.0});
  const std::vector<Point> points = flattened(noise.points);
  const auto three =
      noise.host.evaluate(committedShader("tiling_evaluate.comp"), 0, noise.host.use(), points);
  const auto differing = [&](std::span<const std::uint32_t> spirv) {
    const auto values = noise.host.evaluate(spirv, 0, noise.host.use(), points);
    int count = 0;
    for (std::size_t k = 0; k < points.size(); ++k)
      count += std::abs(values[k][0] - three[k][0]) > 1.0f / 255.0f ? 1 : 0;
    return double(count) / double(points.size());
  };
  const shader::LichenMaterial& material = noise.host.material();
  Difference difference;
  for (std::size_t k = 0; k < points.size(); ++k)
    difference.note(three[k], noise.twin.evaluate(0, material, footprintOf(points[k], material)));
  CHECK(difference.largest <= 1.0 / 255.0);
  CHECK(differing(tiling_evaluate_comp_two_taps) > 0.2);
  CHECK(differing(tiling_evaluate_comp_one_tap) > 0.1);
  CHECK(differing(tiling_evaluate_comp_nearest_level) > 0.1);
}
