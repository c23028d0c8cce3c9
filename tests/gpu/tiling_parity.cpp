// SPDX-License-Identifier: MIT
// The complete tiling method in the shader, through the plugin, against the double-precision oracle
// and the CPU twin.
#include "eight_bit_filter.h"
#include "plugin_host.h"
#include "shared_device.h"
#include "synthetic_noise.h"

#include <lichen/tiling_evaluate.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <tiling_evaluate.comp.anisotropic.h>
#include <tiling_evaluate.comp.joint_table.h>
#include <tiling_evaluate.comp.nearest_level.h>
#include <tiling_evaluate.comp.no_table.h>
#include <tiling_lean.comp.h>

using namespace lichen;
using namespace lichen::test;

namespace {

/// The numbering of tiling_evaluate.comp.
enum Quantity { kValue, kGaussian };

/// Points some tiles around the origin. Footprints range from a hundredth of a texel to a whole
/// tile, round and stretched; every tenth point is at a texel centre with one pixel per texel.
std::vector<Point> samplePoints(float sizeTexels, std::size_t count) {
  std::mt19937 generator(7u);
  std::uniform_real_distribution<float> tiles(-6.0f, 6.0f), level(-3.0f, 8.0f), stretch(0.0f, 4.0f),
      angle(0.0f, 2.0f * std::numbers::pi_v<float>);
  std::vector<Point> points(count);
  for (std::size_t k = 0; k < count; ++k) {
    Point& point = points[k];
    point.uv = {tiles(generator), tiles(generator)};
    const float length = std::exp2(level(generator)) / sizeTexels;
    const float other = length * std::exp2(-stretch(generator)), turn = angle(generator);
    point.gradientX = {length * std::cos(turn), length * std::sin(turn)};
    point.gradientY = {-other * std::sin(turn), other * std::cos(turn)};
    if (k % 2 == 1)
      std::swap(point.gradientX, point.gradientY);
    if (k % 10 == 0)
      point = {{(std::floor(point.uv[0] * sizeTexels) + 0.5f) / sizeTexels,
                (std::floor(point.uv[1] * sizeTexels) + 0.5f) / sizeTexels},
               {1.0f / sizeTexels, 0.0f},
               {0.0f, 1.0f / sizeTexels},
               {}};
  }
  return points;
}

struct Difference {
  double largest = 0.0;
  double fractionBeyond = 0.0; ///< of values that differ by more than 1/1024
};

constexpr double kStrict = 1.0 / 1024.0;

void note(Difference& difference, double error, double share) {
  difference.largest = std::max(difference.largest, error);
  difference.fractionBeyond += error > kStrict ? share : 0.0;
}

/// Compares the committed shader's values (and its Gaussian value and lost variance) with the
/// oracle's.
struct Parity {
  Difference value, gaussian;
};

Parity compare(PluginHost& host, const TilingReference& reference,
               std::span<const std::uint32_t> spirv, const MaterialUse& use,
               const std::vector<Point>& points, std::size_t components) {
  const auto values = host.evaluate(spirv, kValue, use, points);
  const auto gaussians = host.evaluate(spirv, kGaussian, use, points);
  Parity parity;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const TilingReference::Sample expected = reference.evaluate(points[k], host.material());
    for (std::size_t c = 0; c < 3; ++c)
      note(parity.value, std::abs(double(values[k][c]) - expected.value[c]),
           1.0 / double(3 * points.size()));
    for (std::size_t c = 0; c < 4; ++c)
      if (c < components || c == 3)
        note(parity.gaussian, std::abs(double(gaussians[k][c]) - expected.gaussian[c]),
             1.0 / double((components + 1) * points.size()));
  }
  return parity;
}

/// Uses of a map that together change every parameter.
std::vector<MaterialUse> manyUses(const MaterialUse& own, const SyntheticMap& map) {
  std::vector<MaterialUse> all(6, own);
  all[1] = moved(own);
  all[2].placement.tileOrigin[0] = 10000000;
  all[2].placement.tileOrigin[1] = -9999999;
  all[3].placement.tileOrigin[0] = -(std::int64_t(1) << 40);
  all[3].placement.tileOrigin[1] = std::int64_t(1) << 40;
  all[3].parameters.blendSharpness = 3.0;
  all[4].placement.periodTiles[0] = 2.0;
  all[4].placement.periodTiles[1] = 3.0;
  all[4].placement.tileOrigin[0] = -7;
  all[5].placement.periodTiles[0] = all[5].placement.periodTiles[1] = 1.37;
  all[5].parameters.contrast = 1.4;
  // Each of them also rotates its tiles.
  for (std::size_t k = 0; k < 6; ++k) {
    MaterialUse use = all[k];
    use.parameters.tileRotation = map.width == map.height && k % 2 == 0 ? 4 : 2;
    all.push_back(use);
  }
  return all;
}

} // namespace

namespace {

/// What the method itself has: no blend sharpness, period or rotation.
std::vector<MaterialUse> plainUses(const MaterialUse& own, const SyntheticMap& map) {
  const std::vector<MaterialUse> all = manyUses(own, map);
  std::vector<MaterialUse> plain{all[0], all[1], all[2], own};
  plain[3].parameters.contrast = 0.7;
  return plain;
}

/// Parity for every use, for one noise of one map.
std::vector<Parity> parities(const SyntheticMap& map, std::span<const std::uint32_t> spirv,
                             FetchedBy fetchedBy = FetchedBy::level,
                             std::vector<MaterialUse> (&uses)(const MaterialUse&,
                                                              const SyntheticMap&) = manyUses) {
  VulkanDevice* const device = sharedDevice();
  const std::vector<std::byte> glb = syntheticGlb(std::span(&map, 1));
  const Bundle bundle = parseBundle(glb, "synthetic").value();
  const TilingReference reference(bundle, 0, fetchedBy);
  PluginHost host(sharedContext(), glb);
  const std::vector<Point> points = samplePoints(float(map.width), 2000);
  std::vector<Parity> all;
  for (const MaterialUse& use : uses(host.use(), map))
    all.push_back(compare(host, reference, spirv, use, points, std::size_t(map.dimensions)));
  CHECK(device->messages().texts() == std::vector<std::string>{});
  return all;
}

using enum SyntheticTable;

/// Every kind of table with every number of dimensions, and every grain.
const std::vector<SyntheticMap> kSixteenBits = {{3, 64, 64},
                                                {2, 64, 32, false, 3, joint, Grain::x},
                                                {1, 48, 80, false, 5, joint, Grain::y},
                                                {3, 64, 64, false, 0, none},
                                                {2, 64, 32, false, 0, none},
                                                {1, 48, 80, false, 0, none}};

} // namespace

TEST_CASE("16-bit tiling matches the oracle: 99.9 % within 1/1024 and all within 1/255") {
  const std::vector<std::uint32_t> committed = committedShader("tiling_evaluate.comp");
  for (const SyntheticMap& map : kSixteenBits) {
    int use = 0;
    for (const Parity& parity : parities(map, committed)) {
      INFO("D = " << map.dimensions << ", table " << int(map.table) << ", use " << use++);
      CHECK(parity.value.largest <= 1.0 / 255.0);
      CHECK(parity.value.fractionBeyond <= 0.001);
      CHECK(parity.gaussian.largest <= 1.0 / 255.0);
      CHECK(parity.gaussian.fractionBeyond <= 0.001);
    }
  }
}

TEST_CASE("with any grain, a point has one value from every tile origin") {
  for (const Grain grain : {Grain::none, Grain::x, Grain::y}) {
    const SyntheticMap map{3, 64, 64, false, 5, joint, grain};
    const Bundle bundle = syntheticBundle(std::span(&map, 1)).bundle;
    const TilingReference reference(bundle);
    const auto materialAt = [&](std::int64_t x, std::int64_t y) {
      Placement placement;
      placement.tileOriginX = x;
      placement.tileOriginY = y;
      return shaderMaterial(bundle, MaterialNoise(), placement).material;
    };
    const shader::LichenMaterial atZero = materialAt(0, 0);
    for (const auto& [x, y] : {std::array{1, 0}, {2, 1}, {3, -5}, {4, 7}, {-7, 2}, {-1000, 1001}})
      for (int k = 0; k < 200; ++k) {
        // Exact in float, also 1,001 tiles away.
        Point point{{float(37 * k % 128) / 32.0f, float(53 * k % 128) / 32.0f},
                    {1.0f / 64.0f, 0.0f},
                    {0.0f, 1.0f / 64.0f},
                    {}};
        const auto there = reference.evaluate(point, materialAt(x, y));
        point.uv[0] += float(x);
        point.uv[1] += float(y);
        const auto expected = reference.evaluate(point, atZero);
        INFO("grain " << int(grain) << ", tile " << x << ", " << y << ", point " << k);
        for (std::size_t c = 0; c < 3; ++c)
          REQUIRE(there.value[c] == Approx(expected.value[c]).margin(1e-9));
      }
  }
}

TEST_CASE("tiling without its options matches the oracle: 99.9 % within 1/1024 and all within "
          "1/255") {
  for (const SyntheticMap& map : kSixteenBits) {
    int use = 0;
    for (const Parity& parity : parities(map, tiling_lean_comp, FetchedBy::level, plainUses)) {
      INFO("D = " << map.dimensions << ", table " << int(map.table) << ", use " << use++);
      CHECK(parity.value.largest <= 1.0 / 255.0);
      CHECK(parity.value.fractionBeyond <= 0.001);
      CHECK(parity.gaussian.largest <= 1.0 / 255.0);
      CHECK(parity.gaussian.fractionBeyond <= 0.001);
    }
  }
}

TEST_CASE("a shader without the code of the other kind of table decodes like the full shader") {
  struct Variant {
    SyntheticTable table;
    std::span<const std::uint32_t> spirv;
  };
  for (const auto& [table, spirv] : {Variant{joint, tiling_evaluate_comp_joint_table},
                                     Variant{none, tiling_evaluate_comp_no_table}})
    for (const SyntheticMap& map : kSixteenBits) {
      if (map.table != table)
        continue;
      int use = 0;
      for (const Parity& parity : parities(map, spirv)) {
        INFO("D = " << map.dimensions << ", table " << int(table) << ", use " << use++);
        CHECK(parity.value.largest <= 1.0 / 255.0);
        CHECK(parity.value.fractionBeyond <= 0.001);
      }
      if (table != joint)
        break; // one is enough where the code is the same for all dimensions
    }
}

TEST_CASE("a shader without the code of joint tables does not read one") {
  for (const Parity& parity : parities({3, 64, 64}, tiling_evaluate_comp_no_table))
    CHECK(parity.value.largest > 0.1);
}

namespace {

/// Differences from the oracle, over the deviation that 8-bit filtering gives them.
struct FilterErrors {
  std::vector<double> gaussian, value;
  double largestGaussian = 0.0; // not divided
};

/// A noise of one map on a device.
struct OnDevice {
  explicit OnDevice(const SyntheticMap& m)
      : map(m), glb(syntheticGlb(std::span(&map, 1))),
        bundle(parseBundle(glb, "synthetic").value()), host(sharedContext(), glb) {}
  ~OnDevice() { CHECK(device->messages().texts() == std::vector<std::string>{}); }
  OnDevice(const OnDevice&) = delete;
  OnDevice& operator=(const OnDevice&) = delete;

  VulkanDevice* const device = sharedDevice();
  const SyntheticMap map;
  const std::vector<std::byte> glb;
  const Bundle bundle;
  PluginHost host;
};

FilterErrors filterErrors(OnDevice& noise, const MaterialUse& use, double tableLevelError) {
  const SyntheticMap& map = noise.map;
  PluginHost& host = noise.host;
  const TilingReference reference(noise.bundle, 0, FetchedBy::level, tableLevelError);
  const std::vector<Point> points = samplePoints(float(map.width), 2000);
  const std::vector<std::uint32_t> committed = committedShader("tiling_evaluate.comp");
  const auto values = host.evaluate(committed, kValue, use, points);
  const auto gaussians = host.evaluate(committed, kGaussian, use, points);
  const auto contrast = use.parameters.contrast;
  const std::size_t channels = map.dimensions == 1 ? 1 : 3;
  FilterErrors errors;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto expected = reference.evaluate(points[k], host.material());
    const auto deviation = valueDeviation(reference, map, expected, contrast);
    for (std::size_t c = 0; c < channels; ++c)
      errors.value.push_back(std::abs(double(values[k][c]) - expected.value[c]) /
                             (deviation[c] + 1e-6)); // floats of the shader
    for (std::size_t c = 0; c < std::size_t(map.dimensions); ++c) {
      const double error = std::abs(double(gaussians[k][c]) - expected.gaussian[c]);
      errors.gaussian.push_back(error / (fetchDeviation() * contrast));
      errors.largestGaussian = std::max(errors.largestGaussian, error);
    }
  }
  return errors;
}

double quantile99(std::vector<double> values) {
  const auto at = values.begin() + std::ptrdiff_t(values.size() * 99 / 100);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

const std::vector<SyntheticMap> kEightBits = {
    {3, 64, 64, true}, {2, 64, 32, true, 3}, {1, 48, 80, true, 5}, {3, 64, 64, true, 0, none}};

/// Slopes of rotated tiles are decoded tile by tile: valueDeviation() does not fit.
bool isDecodedAsOne(const SyntheticMap& map, const MaterialUse& use) {
  return map.dimensions != 2 || use.parameters.tileRotation <= 1;
}

} // namespace

TEST_CASE("8-bit tiling differs from the oracle by no more than 8-bit filtering explains") {
  for (const SyntheticMap& map : kEightBits) {
    OnDevice noise(map);
    for (const MaterialUse& use : manyUses(noise.host.use(), map)) {
      const FilterErrors errors = filterErrors(noise, use, 0.0);
      INFO("D = " << map.dimensions << ", table " << int(map.table));
      CHECK(quantile99(errors.gaussian) <= kQuantile99);
      // Three interpolations of 1/2 code, and 1/512 of a difference of up to 1 in each, times the
      // sum of the weights over their root sum of squares, sqrt(3), and the contrast.
      constexpr double kMost = 3.0 * (0.5 + 255.0 / 512.0) / 255.0;
      CHECK(errors.largestGaussian <= kMost * std::sqrt(3.0) * use.parameters.contrast);
      if (!isDecodedAsOne(map, use))
        continue;
      CHECK(quantile99(errors.value) <= kQuantile99);
      // Of 6,000 Gaussian values, the greatest is beyond 5 once in 300 times.
      CHECK(*std::max_element(errors.value.begin(), errors.value.end()) <= 5.0);
    }
  }
}

TEST_CASE("a table level that is wrong by 0.1 differs by more than 8-bit filtering explains") {
  for (const SyntheticMap& map : kEightBits) {
    OnDevice noise(map);
    for (const MaterialUse& use : manyUses(noise.host.use(), map))
      if (map.table == joint && isDecodedAsOne(map, use))
        CHECK(quantile99(filterErrors(noise, use, 0.1).value) > kQuantile99);
  }
}

namespace {

/// What the CPU twin says of points on a device.
std::vector<TilingEvaluator::Value> twinValues(OnDevice& noise, bool nearestTableLevel,
                                               const std::vector<Point>& points) {
  const TilingEvaluator twin = TilingEvaluator::create(noise.bundle, 0, nearestTableLevel).value();
  const shader::LichenMaterial& m = noise.host.material();
  const auto toTile = [&](const std::array<float, 2>& v) {
    return std::array{m.uvToTileXX * v[0] + m.uvToTileXY * v[1],
                      m.uvToTileYX * v[0] + m.uvToTileYY * v[1]};
  };
  std::vector<TilingEvaluator::Value> values;
  for (const Point& point : points)
    values.push_back(
        twin.evaluate(0, m, {toTile(point.uv), toTile(point.gradientX), toTile(point.gradientY)}));
  return values;
}

Difference differenceOf(const std::vector<std::array<float, 4>>& values,
                        const std::vector<TilingEvaluator::Value>& expected) {
  Difference difference;
  for (std::size_t k = 0; k < values.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c)
      note(difference, std::abs(double(values[k][c]) - double(expected[k][c])),
           1.0 / double(3 * values.size()));
  return difference;
}

} // namespace

TEST_CASE("the shader matches its CPU twin") {
  const std::vector<std::uint32_t> committed = committedShader("tiling_evaluate.comp");
  for (const SyntheticMap& map : kSixteenBits) {
    OnDevice noise(map);
    const std::vector<Point> points = samplePoints(float(map.width), 1000);
    std::vector<MaterialUse> uses = manyUses(noise.host.use(), map);
    if (map.table != joint) // same lattice and taps: one table kind is enough, plus contrast
      uses = {uses[1], uses[5], uses[6], uses[7], uses[11]};
    for (const MaterialUse& use : uses) {
      const auto values = noise.host.evaluate(committed, kValue, use, points);
      const Difference difference = differenceOf(values, twinValues(noise, false, points));
      INFO("D = " << map.dimensions << ", table " << int(map.table));
      CHECK(difference.largest <= 1.0 / 255.0);
      CHECK(difference.fractionBeyond <= 0.001);
    }
  }
}

TEST_CASE("with the nearest table level the shader matches its CPU twin, and differs from blended "
          "levels") {
  OnDevice noise({3, 64, 64});
  const std::vector<Point> points = samplePoints(64.0f, 2000);
  const MaterialUse own = noise.host.use();
  for (const MaterialUse& use : {own, moved(own)}) {
    const auto values =
        noise.host.evaluate(tiling_evaluate_comp_nearest_level, kValue, use, points);
    const Difference difference = differenceOf(values, twinValues(noise, true, points));
    CHECK(difference.largest <= 1.0 / 255.0);
    CHECK(difference.fractionBeyond <= 0.001);
    CHECK(differenceOf(values, twinValues(noise, false, points)).fractionBeyond > 0.1);
  }
}

TEST_CASE("gradients passed to the sampler change only the driver's level of detail") {
  // lavapipe approximates the level, and levels of independent texels differ strongly: measured
  // 0.016 of the Gaussian value, and 0.025 with contrast 1.4; of values, which have that times the
  // table's slope, 0.033.
  for (const Parity& parity :
       parities({3, 64, 64}, tiling_evaluate_comp_anisotropic, FetchedBy::gradients)) {
    CHECK(parity.value.largest <= 0.04);
    CHECK(parity.gaussian.largest <= 0.03);
  }
}

TEST_CASE("with an anisotropic sampler, the lost variance is that of the square whose area its "
          "probes cover") {
  VulkanDevice* const device = sharedDevice();
  const SyntheticMap map{3, 64, 64};
  const std::vector<std::byte> glb = syntheticGlb(std::span(&map, 1));
  const Bundle bundle = parseBundle(glb, "synthetic").value();
  const TilingReference reference(bundle, 0, FetchedBy::gradients);
  PluginHost host(sharedContext(), glb);
  const std::vector<Point> points = samplePoints(float(map.width), 2000);
  for (const float anisotropy : {1.0f, 4.0f, 16.0f})
    for (MaterialUse use : manyUses(host.use(), map)) {
      use.placement.maxAnisotropy = anisotropy;
      const auto gaussians =
          host.evaluate(tiling_evaluate_comp_anisotropic, kGaussian, use, points);
      double largest = 0.0;
      for (std::size_t k = 0; k < points.size(); ++k)
        largest =
            std::max(largest, std::abs(double(gaussians[k][3]) -
                                       reference.evaluate(points[k], host.material()).gaussian[3]));
      INFO("anisotropy " << anisotropy);
      // Samplers have 8 bits of a level, between which the loss differs by up to 0.54.
      CHECK(largest <= 1.0 / 255.0);
    }
  CHECK(device->messages().texts() == std::vector<std::string>{});
}
