// SPDX-License-Identifier: MIT
// Texton noise in the shader, through the plugin, against the CPU twin; and both against an oracle
// that sums all impacts of a periodic domain in double precision.
#include "texton_reference.h"
#include "texton_twins.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <texton_evaluate.comp.anisotropic.h>

using namespace lichen;
using namespace lichen::test;

namespace {

constexpr const char* kPass = "texton_evaluate.comp";
/// The numbering of texton_evaluate.comp.
enum Quantity { kValue, kGaussian, kGradient, kImpacts, kLost };

struct MixedPoint {
  Point point;
  /// Mix weight, its derivatives per tile, and 0 if the material sets them.
  std::array<float, 4> mixPosition{0.0f, 0.0f, 0.0f, 1.0f};
};

constexpr double kStrict = 1.0 / 1024.0;

struct Difference {
  double largest = 0.0;
  std::size_t beyond = 0; ///< differences above 1/1024
  std::size_t count = 0;

  void note(double error) {
    largest = std::max(largest, error);
    beyond += error > kStrict ? 1 : 0;
    ++count;
  }
  [[nodiscard]] double fractionBeyond() const { return double(beyond) / double(count); }
};

/// Points some tiles around the origin. Footprints range from a quarter of a texel to beyond the
/// last mip.
std::vector<MixedPoint> samplePoints(const SyntheticTexton& texton, std::size_t count) {
  std::mt19937 generator(11u);
  std::uniform_real_distribution<float> tiles(-3.0f, 3.0f), level(-2.0f, 6.0f), stretch(0.0f, 3.0f),
      angle(0.0f, 2.0f * std::numbers::pi_v<float>), weight(-0.2f, 1.2f);
  std::vector<MixedPoint> points(count);
  for (MixedPoint& mixed : points) {
    Point& point = mixed.point;
    point.uv = {tiles(generator), tiles(generator)};
    const float length = std::exp2(level(generator)) / float(texton.texelsPerTileX);
    const float other = length * std::exp2(-stretch(generator)), turn = angle(generator);
    point.gradientX = {length * std::cos(turn), length * std::sin(turn)};
    point.gradientY = {-other * std::sin(turn), other * std::cos(turn)};
    mixed.mixPosition = {weight(generator), weight(generator), weight(generator), 1.0f};
  }
  return points;
}

/// Uses that together change every parameter.
std::vector<MaterialUse> manyUses(const MaterialUse& own) {
  std::vector<MaterialUse> all(5, own);
  all[1] = moved(own);
  all[1].parameters.pointProcess = LICHEN_POINT_PROCESS_POISSON;
  all[2].placement.tileOrigin[0] = -(std::int64_t(1) << 40);
  all[2].placement.tileOrigin[1] = std::int64_t(1) << 40;
  all[2].parameters.contrast = 1.4;
  all[2].parameters.impacts = 4.0;
  all[3].placement.periodTiles[0] = 2.0;
  all[3].placement.periodTiles[1] = 3.0;
  all[3].placement.tileOrigin[0] = -7;
  all[3].parameters.pointProcess = LICHEN_POINT_PROCESS_POISSON;
  all[4].placement.periodTiles[0] = all[4].placement.periodTiles[1] = 1.37;
  return all;
}

TileFootprint footprintOf(const Point& point, const shader::LichenMaterial& m) {
  const auto toTile = [&](const std::array<float, 2>& v) {
    return std::array{m.uvToTileXX * v[0] + m.uvToTileXY * v[1],
                      m.uvToTileYX * v[0] + m.uvToTileYY * v[1]};
  };
  TileFootprint at{toTile(point.uv), toTile(point.gradientX), toTile(point.gradientY)};
  return at;
}

MixPlace mixOf(const MixedPoint& mixed) {
  return {mixed.mixPosition[0], {mixed.mixPosition[1], mixed.mixPosition[2]}};
}

/// All orders, formats and channel counts; no side is a multiple of a coarse texel.
const std::vector<SyntheticTexton> kTextons = {
    {},
    {.coefficientsX = 8, .coefficientsY = 30, .order = 1, .mipLevels = 2, .channels = 2},
    {.order = 3},
    {.order = 3, .mipLevels = 1, .channels = 1},
    {.order = 1, .steps = 3, .channels = 1}};

} // namespace

TEST_CASE("the texton shader matches its CPU twin: 99.9 % within 1/1024 and all within 1/255") {
  for (const SyntheticTexton& texton : kTextons) {
    TextonTwins twins(kPass, texton);
    const std::vector<MixedPoint> points = samplePoints(texton, 400);
    int number = 0;
    for (const MaterialUse& use : manyUses(twins.host.use())) {
      const auto values = twins.shader(kValue, use, points);
      const auto gaussians = twins.shader(kGaussian, use, points);
      const auto lost = twins.shader(kLost, use, points);
      Difference value, gaussian, loss;
      for (std::size_t k = 0; k < points.size(); ++k) {
        const TileFootprint at = footprintOf(points[k].point, twins.host.material());
        const auto expected = twins.twin.evaluate(0, twins.host.material(), at, mixOf(points[k]));
        const auto expectedG = twins.twin.gaussian(0, twins.host.material(), at, mixOf(points[k]));
        const auto expectedLost =
            twins.twin.lostVariance(0, twins.host.material(), at, mixOf(points[k]));
        for (std::size_t c = 0; c < 4; ++c) {
          value.note(std::abs(double(values[k][c]) - double(expected[c])));
          if (c < std::size_t(texton.channels)) {
            gaussian.note(std::abs(double(gaussians[k][c]) - double(expectedG[c])));
            loss.note(std::abs(double(lost[k][c]) - double(expectedLost[c])));
          }
        }
      }
      INFO("order " << texton.order << ", channels " << texton.channels << ", steps "
                    << texton.steps << ", use " << number++);
      CHECK(value.largest <= 1.0 / 255.0);
      CHECK(value.fractionBeyond() <= 0.001);
      CHECK(gaussian.largest <= 1.0 / 255.0);
      CHECK(gaussian.fractionBeyond() <= 0.001);
      CHECK(loss.largest <= 1.0 / 255.0);
      CHECK(loss.fractionBeyond() <= 0.001);
    }
  }
}

TEST_CASE("textons of order 0 match their CPU twin, except at points on the border of a "
          "coefficient") {
  TextonTwins twins(kPass, SyntheticTexton{.order = 0});
  const std::vector<MixedPoint> points = samplePoints({}, 600);
  for (const MaterialUse& use : manyUses(twins.host.use())) {
    const auto values = twins.shader(kGaussian, use, points);
    Difference difference;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const auto expected = twins.twin.gaussian(
          0, twins.host.material(), footprintOf(points[k].point, twins.host.material()));
      for (std::size_t c = 0; c < 4; ++c)
        difference.note(std::abs(double(values[k][c]) - double(expected[c])));
    }
    // Coordinates of some 100 texels are rounded to 2^-17. With 30 impacts, a fraction of 3e-4 of
    // points has one on the other side of one of two borders.
    CHECK(difference.fractionBeyond() <= 0.002);
  }
}

namespace {

/// Points with the footprint of one mip level.
struct OracleCase {
  SyntheticTexton texton;
  bool poisson = false;
  std::uint32_t mip = 0;

  /// A periodic placement.
  [[nodiscard]] MaterialUse changed(MaterialUse use) const {
    use.placement.periodTiles[0] = 2.0;
    use.placement.periodTiles[1] = 1.0;
    use.placement.tileOrigin[0] = poisson ? 5 : 0;
    use.parameters.pointProcess =
        poisson ? LICHEN_POINT_PROCESS_POISSON : LICHEN_POINT_PROCESS_STRATIFIED;
    return use;
  }
};

std::vector<OracleCase> oracleCases() {
  std::vector<OracleCase> all;
  for (const int order : {0, 1, 3})
    for (const bool poisson : {false, true})
      for (const std::uint32_t mip : {0u, 1u, 2u})
        all.push_back(
            {{.order = order, .steps = order == 1 ? 3 : 1, .wholeFloats = true}, poisson, mip});
  return all;
}

} // namespace

TEST_CASE("the shader and its CPU twin match the oracle, which sums over all impacts of a "
          "periodic domain") {
  for (const OracleCase& one : oracleCases()) {
    TextonTwins twins(kPass, one.texton);
    std::vector<MixedPoint> points = samplePoints(one.texton, 30);
    for (MixedPoint& mixed : points) {
      // Half a level above the mip's.
      const float level = one.mip == 0 ? 0.0f : float(one.mip) + 0.5f;
      mixed.point.gradientX = {std::exp2(level) / float(one.texton.texelsPerTileX), 0.0f};
      mixed.point.gradientY = {0.0f, std::exp2(level) / float(one.texton.texelsPerTileY)};
    }
    const auto values = twins.shader(kGaussian, one.changed(twins.host.use()), points);
    const TextonReference reference(twins.bundle, twins.host.material());
    const NoiseMap& map = twins.bundle.noises[0].maps[0];
    std::size_t strangers = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const TileFootprint at = footprintOf(points[k].point, twins.host.material());
      const MixPlace mix = mixOf(points[k]);
      const auto twin = twins.twin.gaussian(0, twins.host.material(), at, mix);
      const TextonReference::Sum expected =
          reference.at(double(at.position[0]), double(at.position[1]), one.mip, double(mix.weight),
                       {double(mix.gradient[0]), double(mix.gradient[1])});
      for (std::size_t c = 0; c < 3; ++c) {
        const double gaussian =
            0.5 + expected.value[c] / (6.0 * deviationAt(map, double(mix.weight), c));
        // 30 impacts at coordinates of 100 texels, rounded to 2^-17, with slopes up to 0.2 per
        // texel: less than 5e-5. Order 0 and the steps of a mix have borders, where rounding may
        // select another texton.
        constexpr double kTolerance = 1e-4;
        const double worst = std::max(std::abs(double(values[k][c]) - gaussian),
                                      std::abs(double(twin[c]) - gaussian));
        strangers += worst > kTolerance ? 1u : 0u;
      }
    }
    INFO("order " << one.texton.order << ", mip " << one.mip << ", process " << int(one.poisson));
    CHECK(strangers <= (one.texton.order == 3 ? 0u : 3u)); // one point
  }
}

TEST_CASE("derivatives of order 3 match the spline, and only impacts in reach are counted") {
  const SyntheticTexton texton{.order = 3, .channels = 1, .wholeFloats = true};
  TextonTwins twins(kPass, texton);
  std::vector<MixedPoint> points = samplePoints(texton, 200);
  for (MixedPoint& mixed : points)
    mixed.point.gradientX = mixed.point.gradientY = {0.0f, 0.0f};
  MaterialUse use = twins.host.use();
  use.placement.periodTiles[0] = use.placement.periodTiles[1] = 2.0;
  const auto gradients = twins.shader(kGradient, use, points);
  const auto counts = twins.shader(kImpacts, use, points);
  const TextonReference reference(twins.bundle, twins.host.material());
  const NoiseMap& map = twins.bundle.noises[0].maps[0];
  double mean = 0.0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const TileFootprint at = footprintOf(points[k].point, twins.host.material());
    const auto twin = twins.twin.gradient(0, twins.host.material(), at);
    const TextonReference::Sum expected =
        reference.at(double(at.position[0]), double(at.position[1]), 0);
    const double values[] = {map.mean[0] + expected.value[0], expected.gradient[0],
                             expected.gradient[1]};
    for (std::size_t c = 0; c < 3; ++c) {
      // The slope's own slope is below 0.08 per texel, at 64 texels per tile, with the same
      // rounding.
      const double tolerance = c == 0 ? 1e-4 : 2e-3;
      REQUIRE(double(gradients[k][c]) == Approx(values[c]).margin(tolerance));
      REQUIRE(double(twin[c]) == Approx(values[c]).margin(tolerance));
    }
    mean += double(counts[k][0]) / double(points.size());
  }
  // A Bernoulli variable for each cell: 200 points, each with a standard deviation of at most
  // sqrt(30 / 4); 5 standard errors. The 30 impacts are counted in a rectangular window of (24, 21)
  // texels.
  CHECK(mean == Approx(30.0).margin(1.0));
}

TEST_CASE("a height's value and differences match the CPU twin at all levels, orders and "
          "parameters, also for a mix") {
  for (const SyntheticTexton& texton :
       {SyntheticTexton{.order = 0, .channels = 1}, SyntheticTexton{.order = 1, .channels = 1},
        SyntheticTexton{.order = 3, .steps = 3, .channels = 1}}) {
    TextonTwins twins(kPass, texton);
    const std::vector<MixedPoint> points = samplePoints(texton, 300);
    int number = 0;
    for (const MaterialUse& use : manyUses(twins.host.use())) {
      const auto gradients = twins.shader(kGradient, use, points);
      Difference difference;
      for (std::size_t k = 0; k < points.size(); ++k) {
        const auto expected = twins.twin.gradient(
            0, twins.host.material(), footprintOf(points[k].point, twins.host.material()),
            mixOf(points[k]));
        for (std::size_t c = 0; c < 3; ++c) // per texel, like the values
          difference.note(std::abs(double(gradients[k][c]) - double(expected[c])) /
                          (c == 0 ? 1.0 : double(texton.texelsPerTileX)));
      }
      INFO("order " << texton.order << ", steps " << texton.steps << ", use " << number++);
      // Order 0 and mixes have borders; rounding may move points to either side.
      const bool hasBorders = texton.order == 0 || texton.steps > 1;
      CHECK((hasBorders || difference.largest <= 1.0 / 255.0));
      CHECK(difference.fractionBeyond() <= (hasBorders ? 0.003 : 0.001));
    }
  }
}

TEST_CASE("a point far from the origin has the impacts of its tile, even if the number of "
          "cells overflows an int") {
  TextonTwins twins(
      kPass, SyntheticTexton{.texelsPerTileX = 16384, .texelsPerTileY = 16384, .channels = 1});
  for (const auto& [period, tile] :
       {std::pair{0.0, std::int64_t(1) << 20}, std::pair{2.0, -(std::int64_t(1) << 24)}}) {
    MaterialUse near = twins.host.use();
    near.parameters.impacts = 1000.0; // 25,343 cells per tile
    near.placement.periodTiles[0] = near.placement.periodTiles[1] = period;
    MaterialUse far = near;
    far.placement.tileOrigin[0] = tile;
    far.placement.tileOrigin[1] = -tile;
    std::vector<MixedPoint> point(1);
    const auto expected = twins.shader(kGaussian, far, point);
    point[0].point.uv = {float(tile), float(-tile)};
    const auto found = twins.shader(kGaussian, near, point);
    const auto twin = twins.twin.gaussian(0, twins.host.material(),
                                          footprintOf(point[0].point, twins.host.material()));
    INFO("tile " << tile << ", period " << period);
    CHECK(double(found[0][0]) == Approx(double(expected[0][0])).margin(1e-5));
    CHECK(double(twin[0]) == Approx(double(expected[0][0])).margin(kStrict));
  }
  // With other tile sizes a float stores the cell size with an error, but shader and CPU twin read
  // the same float.
  for (const auto& [period, tile] :
       {std::pair{0.0, 1234567.0f}, std::pair{3.0, 1234567.0f}, std::pair{1.37, -7654321.0f}}) {
    MaterialUse use = twins.host.use();
    use.placement.periodTiles[0] = use.placement.periodTiles[1] = period;
    std::vector<MixedPoint> point(1);
    point[0].point.uv = {tile, 0.3f * tile};
    const auto value = twins.shader(kGaussian, use, point);
    const auto twin = twins.twin.gaussian(0, twins.host.material(),
                                          footprintOf(point[0].point, twins.host.material()));
    INFO("tile " << tile << ", period " << period);
    CHECK(double(value[0][0]) == Approx(double(twin[0])).margin(kStrict));
  }
}

TEST_CASE("a sampler without anisotropy gives the same result from gradients as from levels") {
  for (const int order : {0, 1, 3}) {
    // A square tile, so that gradients at right angles are also the footprint's axes in texels. The
    // footprints have whole levels, because lavapipe approximates levels in between.
    const SyntheticTexton texton{.order = order, .texelsPerTileY = 64};
    TextonTwins twins(kPass, texton);
    std::vector<MixedPoint> points = samplePoints(texton, 200);
    int level = -1;
    for (MixedPoint& mixed : points) {
      std::array<float, 2>& gradient = mixed.point.gradientX;
      const float length = std::hypot(gradient[0], gradient[1]);
      level = level == 3 ? -1 : level + 1;
      for (float& along : gradient)
        along *= std::exp2(float(level) + (level > 0 ? 0.5f : 0.0f)) /
                 (length * float(texton.texelsPerTileX));
      mixed.point.gradientY = {-gradient[1], gradient[0]};
    }
    for (const Quantity quantity : {kGaussian, kGradient}) {
      const auto values =
          twins.host.evaluate(texton_evaluate_comp_anisotropic, quantity, twins.host.use(), points);
      const auto trilinear = twins.shader(quantity, twins.host.use(), points);
      Difference difference;
      for (std::size_t k = 0; k < points.size(); ++k)
        for (std::size_t c = 0; c < 3; ++c)
          difference.note(std::abs(double(values[k][c]) - double(trilinear[k][c])) /
                          (quantity == kGradient && c > 0 ? 64.0 : 1.0));
      INFO("order " << order << ", quantity " << int(quantity));
      CHECK(difference.largest <= 1.0 / 255.0);
    }
  }
}

TEST_CASE("the gradient of a mix includes the mean's slope and matches the oracle in shader "
          "and CPU twin") {
  const SyntheticTexton texton{.order = 3, .steps = 3, .channels = 1, .wholeFloats = true};
  TextonTwins twins(kPass, texton);
  std::vector<MixedPoint> points = samplePoints(texton, 200);
  for (MixedPoint& mixed : points)
    mixed.point.gradientX = mixed.point.gradientY = {0.0f, 0.0f};
  MaterialUse use = twins.host.use();
  use.placement.periodTiles[0] = use.placement.periodTiles[1] = 2.0;
  const auto gradients = twins.shader(kGradient, use, points);
  const TextonReference reference(twins.bundle, twins.host.material());
  const NoiseMap& map = twins.bundle.noises[0].maps[0];
  // The means of the three steps lie on a line.
  const double meanSlope = map.as<TextonMap>().laterSteps[1].mean[0] - map.mean[0];
  REQUIRE(map.as<TextonMap>().laterSteps[0].mean[0] == Approx(map.mean[0] + 0.5 * meanSlope));
  REQUIRE(meanSlope == Approx(-0.2)); // a hundred tolerances
  for (std::size_t k = 0; k < points.size(); ++k) {
    const TileFootprint at = footprintOf(points[k].point, twins.host.material());
    const MixPlace mix = mixOf(points[k]);
    const auto twin = twins.twin.gradient(0, twins.host.material(), at, mix);
    const std::array weightSlope{double(mix.gradient[0]), double(mix.gradient[1])};
    const auto weight = double(mix.weight);
    const TextonReference::Sum sum =
        reference.at(double(at.position[0]), double(at.position[1]), 0, weight, weightSlope);
    const double slope = weight > 0.0 && weight < 1.0 ? meanSlope : 0.0;
    const double expected[] = {
        map.mean[0] + meanSlope * std::clamp(weight, 0.0, 1.0) + sum.value[0],
        sum.gradient[0] + slope * weightSlope[0], sum.gradient[1] + slope * weightSlope[1]};
    for (std::size_t c = 0; c < 3; ++c) {
      // As without a mix. An impact keeps its texton at any point, because the weight is linear.
      // Rounding changes the texton of one of 6000 impacts if its weight is within 1e-7 of one of
      // two borders between steps: once in 600 such tests.
      const double tolerance = c == 0 ? 1e-4 : 2e-3;
      INFO("point " << k << ", component " << c);
      CHECK(double(gradients[k][c]) == Approx(expected[c]).margin(tolerance));
      CHECK(double(twin[c]) == Approx(expected[c]).margin(tolerance));
    }
  }
}

TEST_CASE("a constant or a direction of the weight follows the material, not the noise's "
          "placement") {
  const SyntheticTexton texton{.order = 1, .steps = 5};
  BundleFile file = syntheticTextonBundle(texton);
  MixWeight& mix = file.bundle.materials[0]->mix;
  SECTION("a constant") { mix.weight = 0.3; }
  SECTION("a direction") {
    mix.source = MixSource::direction;
    mix.start = {0.5, -2.0};
    mix.end = {3.0, 1.0};
  }
  TextonTwins twins(kPass, encodeGlb(file).value());
  std::vector<MixedPoint> points = samplePoints(texton, 200);
  for (MixedPoint& mixed : points)
    mixed.mixPosition = {};
  MaterialUse use = twins.host.use();
  use.parameters.scale = 0.8;
  use.parameters.rotation = 0.6;
  use.parameters.offset[0] = 2.25;
  use.placement.tileOrigin[0] = 2;
  use.placement.tileOrigin[1] = -1;
  const auto gaussians = twins.shader(kGaussian, use, points);
  // Texture coordinates of a tile coordinate: the inverse rotation, divided by the scale.
  const auto weightAt = [&](double tileX, double tileY) {
    if (mix.source == MixSource::constant)
      return mix.weight;
    const double x = use.parameters.scale * (tileX - use.parameters.offset[0]),
                 y = use.parameters.scale * tileY;
    const double uv[] = {
        std::cos(use.parameters.rotation) * x - std::sin(use.parameters.rotation) * y,
        std::sin(use.parameters.rotation) * x + std::cos(use.parameters.rotation) * y};
    const double way[] = {mix.end[0] - mix.start[0], mix.end[1] - mix.start[1]};
    return ((uv[0] - mix.start[0]) * way[0] + (uv[1] - mix.start[1]) * way[1]) /
           (way[0] * way[0] + way[1] * way[1]);
  };
  Difference difference;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const TileFootprint at = footprintOf(points[k].point, twins.host.material());
    // Relative to the host's origin, except for the whole tiles of the offset.
    const double x = double(at.position[0]) + double(twins.host.material().offsetX) +
                     double(use.placement.tileOrigin[0]) + 2.0;
    const double y = double(at.position[1]) + double(twins.host.material().offsetY) +
                     double(use.placement.tileOrigin[1]);
    const MixPlace place{float(weightAt(x, y)),
                         {float(weightAt(x + 1.0, y) - weightAt(x, y)),
                          float(weightAt(x, y + 1.0) - weightAt(x, y))}};
    const auto expected = twins.twin.gaussian(0, twins.host.material(), at, place);
    for (std::size_t c = 0; c < 3; ++c)
      difference.note(std::abs(double(gaussians[k][c]) - double(expected[c])));
  }
  // Weights are below 4, from at most ten roundings of 2^-23. With 6000 impacts and four borders
  // between steps, 0.06 impacts get another texton. Two such points occur once in 600 runs.
  CHECK(difference.beyond <= 3); // channels of one point
}
