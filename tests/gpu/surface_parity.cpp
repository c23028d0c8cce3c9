// SPDX-License-Identifier: MIT
// Texton noise on surfaces in the shader, through the plugin, against the CPU twin; and both
// against an oracle that sums all impacts of a large box in double precision.
#include "surface_points.h"
#include "surface_reference.h"
#include "texton_reference.h"
#include "texton_twins.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>

using namespace lichen;
using namespace lichen::test;

namespace {

constexpr const char* kPass = "surface_evaluate.comp";
/// The numbering of surface_evaluate.comp.
enum Quantity { kValue, kGaussian, kImpacts, kLost };

using Vec = SurfaceReference::Vec;

MixPlace mixOf(const SurfacePoint& point) {
  return {point.gradientX[3], {point.gradientY[3], point.normal[3]}};
}

} // namespace

TEST_CASE("the surface shader matches its CPU twin: 99.9 % within 1/1024 and all within 1/255") {
  for (const SyntheticTexton& texton :
       {SyntheticTexton{},
        SyntheticTexton{
            .coefficientsX = 8, .coefficientsY = 30, .order = 1, .mipLevels = 2, .channels = 2},
        SyntheticTexton{.order = 3, .channels = 1}, SyntheticTexton{.steps = 3, .channels = 1}}) {
    TextonTwins twins(kPass, texton);
    const std::vector<SurfacePoint> points = surfacePoints(texton.texelsPerTileX, 250);
    int number = 0;
    for (const MaterialUse& use : surfaceUses(twins.host.use())) {
      const auto values = twins.shader(kValue, use, points);
      const auto gaussians = twins.shader(kGaussian, use, points);
      const auto lost = twins.shader(kLost, use, points);
      double largest = 0.0, beyond = 0.0;
      for (std::size_t k = 0; k < points.size(); ++k) {
        const SurfaceFootprint at = footprintOf(points[k]);
        const auto value = twins.twin.evaluate(0, twins.host.material(), at, mixOf(points[k]));
        const auto gaussian = twins.twin.gaussian(0, twins.host.material(), at, mixOf(points[k]));
        const auto expectedLost =
            twins.twin.lostVariance(0, twins.host.material(), at, mixOf(points[k]));
        for (std::size_t c = 0; c < 4; ++c) {
          double error = std::abs(double(values[k][c]) - double(value[c]));
          if (c < std::size_t(texton.channels))
            error = std::max({error, std::abs(double(gaussians[k][c]) - double(gaussian[c])),
                              std::abs(double(lost[k][c]) - double(expectedLost[c]))});
          largest = std::max(largest, error);
          beyond += error > 1.0 / 1024.0 ? 1.0 / (4.0 * double(points.size())) : 0.0;
        }
      }
      INFO("order " << texton.order << ", channels " << texton.channels << ", steps "
                    << texton.steps << ", use " << number++);
      CHECK(largest <= 1.0 / 255.0);
      CHECK(beyond <= 0.001);
    }
  }
}

TEST_CASE("the surface shader and its CPU twin match the oracle, which sums over all impacts") {
  for (const auto& [order, steps] :
       {std::pair{0, 1}, std::pair{1, 1}, std::pair{1, 3}, std::pair{3, 1}})
    for (const std::uint32_t mip : {0u, 1u, 2u}) {
      const SyntheticTexton texton{.order = order, .steps = steps, .wholeFloats = true};
      TextonTwins twins(kPass, texton);
      std::vector<SurfacePoint> points = surfacePoints(texton.texelsPerTileX, 16);
      MaterialUse use = onSurface(twins.host.use());
      use.parameters.pointProcess =
          mip == 1 ? LICHEN_POINT_PROCESS_POISSON : LICHEN_POINT_PROCESS_STRATIFIED;
      use.parameters.rotation = order == 3 ? 0.4 : 0.0;
      use.parameters.scale = mip == 2 ? 1.7 : 1.0;
      use.placement.tileOrigin[1] = 12;
      use.placement.tileOrigin[2] = -5;
      for (SurfacePoint& point : points) {
        const SurfaceFrame frame = frameOf(point, 0.0);
        // Textons are fetched half a level below the footprint's (docs/decisions/018).
        const double level = mip > 0 ? mip + 0.5 : 0.0;
        const double pixel = std::exp2(level) / texton.texelsPerTileX * use.parameters.scale;
        for (std::size_t k = 0; k < 3; ++k) {
          point.gradientX[k] = float(pixel * frame.right[k]);
          point.gradientY[k] = float(pixel * frame.down[k]);
        }
      }
      const auto values = twins.shader(kGaussian, use, points);
      const SurfaceReference reference(twins.bundle, twins.host.material());
      const NoiseMap& map = twins.bundle.noises[0].maps[0];
      std::size_t strangers = 0;
      for (std::size_t k = 0; k < points.size(); ++k) {
        const SurfacePoint& point = points[k];
        const SurfaceFrame frame = frameOf(point, use.parameters.rotation);
        const MixPlace mix = mixOf(point);
        const auto twin = twins.twin.gaussian(0, twins.host.material(), footprintOf(point), mix);
        const Vec expected = reference.at(
            {double(point.position[0]), double(point.position[1]), double(point.position[2])},
            frame.right, frame.down, frame.outward, mip, double(mix.weight),
            {double(mix.gradient[0]), double(mix.gradient[1])});
        for (std::size_t c = 0; c < 3; ++c) {
          const double gaussian =
              0.5 + expected[c] / (6.0 * deviationAt(map, double(mix.weight), c));
          // 60 impacts at positions of 200 texels, rounded to 2^-17 in each of three steps, with
          // slopes up to 0.2 per texel: less than 1e-4, and the level's logarithm as much again.
          // Order 0 and the steps of a mix have borders, where rounding may select another texton.
          constexpr double kTolerance = 3e-4;
          const double worst = std::max(std::abs(double(values[k][c]) - gaussian),
                                        std::abs(double(twin[c]) - gaussian));
          strangers += worst > kTolerance ? 1u : 0u;
        }
      }
      INFO("order " << order << ", steps " << steps << ", mip " << mip);
      CHECK(strangers <= (order == 0 || steps > 1 ? 3u : 0u)); // one point
    }
}

TEST_CASE("surface noise far from the origin uses the cubes of its tile, even if their number "
          "overflows an int") {
  TextonTwins twins(
      kPass, SyntheticTexton{.texelsPerTileX = 16384, .texelsPerTileY = 16384, .channels = 1});
  for (const std::int64_t tile : {std::int64_t(1) << 24, -(std::int64_t(1) << 27)}) {
    MaterialUse near = onSurface(twins.host.use());
    near.parameters.impacts = 1000.0; // some thousands of cubes per tile
    MaterialUse far = near;
    far.placement.tileOrigin[0] = tile;
    far.placement.tileOrigin[1] = -tile;
    far.placement.tileOrigin[2] = tile;
    std::vector<SurfacePoint> point(1);
    point[0].normal = {0.0f, 0.6f, 0.8f, 0.0f};
    point[0].tangent = {1.0f, 0.0f, 0.0f, 1.0f};
    const auto expected = twins.shader(kGaussian, far, point);
    point[0].position = {float(tile), float(-tile), float(tile), 0.0f};
    const auto found = twins.shader(kGaussian, near, point);
    const auto twin = twins.twin.gaussian(0, twins.host.material(), footprintOf(point[0]));
    INFO("tile " << tile);
    CHECK(double(found[0][0]) == Approx(double(expected[0][0])).margin(1e-5));
    CHECK(double(twin[0]) == Approx(double(expected[0][0])).margin(1e-4));
  }
}

TEST_CASE("surface mapping uses the material's constant mix weight") {
  const SyntheticTexton texton{.steps = 5, .channels = 1};
  BundleFile file = syntheticTextonBundle(texton);
  file.bundle.materials[0]->mix.weight = 0.6;
  TextonTwins twins(kPass, encodeGlb(file).value());
  std::vector<SurfacePoint> points = surfacePoints(texton.texelsPerTileX, 100);
  for (SurfacePoint& point : points)
    point.position[3] = 0.0f; // so that its weight and derivatives are not read
  const auto gaussians = twins.shader(kGaussian, onSurface(twins.host.use()), points);
  std::size_t strangers = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto expected =
        twins.twin.gaussian(0, twins.host.material(), footprintOf(points[k]), {0.6f, {}});
    strangers += std::abs(double(gaussians[k][0]) - double(expected[0])) > 1.0 / 255.0 ? 1u : 0u;
  }
  CHECK(strangers == 0);
}

TEST_CASE("the shader counts as many impacts on a surface as proposition 3 predicts") {
  const SyntheticTexton texton;
  TextonTwins twins(kPass, texton);
  std::vector<SurfacePoint> points = surfacePoints(texton.texelsPerTileX, 400);
  for (SurfacePoint& point : points)
    point.gradientX = point.gradientY = {};
  const auto counts = twins.shader(kImpacts, onSurface(twins.host.use()), points);
  double mean = 0.0;
  for (const auto& count : counts)
    mean += double(count[0]) / double(counts.size());
  // lambda times the box of (22, 19, sqrt(22 * 19)) texels.
  const double cube = double(textonPart(twins.host.material()).surfaceCubeTexels);
  const double expected = std::pow(22.0 * 19.0, 1.5) / (cube * cube * cube);
  CHECK(expected == Approx(60.0).epsilon(0.1));
  // 400 points, with a Bernoulli variable for each of some 90 cubes on the border: 5 standard
  // errors.
  CHECK(mean == Approx(expected).margin(5.0 * std::sqrt(90.0 / 4.0 / 400.0)));
}

TEST_CASE("a period is an error for surface mapping") {
  TextonTwins twins(kPass, SyntheticTexton{});
  MaterialUse use = onSurface(twins.host.use());
  use.placement.periodTiles[0] = use.placement.periodTiles[1] = 2.0;
  LichenDiagnostic diagnostic;
  LICHEN_INIT(diagnostic, LICHEN_STRUCTURE_DIAGNOSTIC);
  shader::LichenMaterial block;
  CHECK(lichenFillMaterial(&use.parameters, &use.placement, &block, &diagnostic) ==
        LICHEN_ERROR_USAGE);
  CHECK(std::string(diagnostic.text) ==
        "periodTiles 2 is not supported for surface mapping, which cannot repeat; set it to 0");
}
