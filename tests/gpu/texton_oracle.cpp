// SPDX-License-Identifier: MIT
// Textons in the plane and on surfaces, on a device and in C++, against an oracle that sums all
// impacts in double precision, and against what their point process and mix say.
#include "device_noise.h"
#include "shared_device.h"
#include "synthetic_texton.h"
#include "texton_reference.h"

#include <lichen/shader_parameters.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace lichen;
using namespace lichen::test;

namespace {

void setPeriod(MaterialUse& use, double x, double y) {
  use.placement.periodTiles[0] = x;
  use.placement.periodTiles[1] = y;
}

/// Points whose fetches are at one mip. Textons are fetched half a level below the footprint's
/// (docs/decisions/003).
std::vector<SamplePoint> pointsAtMip(const SyntheticTexton& texton, std::uint32_t mip, double scale,
                                     std::size_t count) {
  std::vector<SamplePoint> points = samplePoints(count);
  const double pixel = scale * std::exp2(mip > 0 ? mip + 0.5 : 0.0);
  for (SamplePoint& point : points) {
    point.plane.gradientX = {float(pixel / texton.texelsPerTileX), 0.0f};
    point.plane.gradientY = {0.0f, float(pixel / texton.texelsPerTileY)};
    const SurfaceFrame frame = frameOf(point, 0.0);
    for (std::size_t k = 0; k < 3; ++k) {
      point.dx[k] = float(pixel / texton.texelsPerTileX * frame.right[k]);
      point.dy[k] = float(pixel / texton.texelsPerTileX * frame.down[k]);
    }
  }
  return points;
}

/// Points of the plane or of a surface at which any channel, on the device or in C++, differs from
/// the oracle.
std::size_t strangersOf(DeviceNoise& noise, Mapping mapping, std::uint32_t mip,
                        const MaterialUse& use, const std::vector<SamplePoint>& points,
                        double tolerance) {
  const auto values = noise.drawn(kGaussian, use, points);
  const TextonReference reference(noise.bundle, noise.host.material());
  std::size_t strangers = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const SamplePoint& p = points[k];
    const TileFootprint at = noise.onPlane(p.plane);
    const Vec sum =
        mapping == Mapping::uv
            ? reference.inPlane(double(at.position[0]), double(at.position[1]), mip, p.mix)
            : reference.onSurface(
                  {double(p.position[0]), double(p.position[1]), double(p.position[2])},
                  frameOf(p, use.parameters.rotation), mip, p.mix);
    const auto computed = noise.gaussian(p).value;
    double worst = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double expected = reference.gaussian(sum, double(p.mix.weight), c);
      worst = std::max({worst, std::abs(double(values[k][c]) - expected),
                        std::abs(double(computed[c]) - expected)});
    }
    strangers += worst > tolerance ? 1 : 0;
  }
  return strangers;
}

} // namespace

TEST_CASE("textons in the plane and on surfaces match the oracle, which sums over all impacts") {
  for (const Mapping mapping : {Mapping::uv, Mapping::surface})
    for (const auto& [order, steps] : {std::pair{0, 1}, {1, 1}, {1, 3}, {3, 1}}) {
      const SyntheticTexton texton{.order = order, .steps = steps, .wholeFloats = true};
      DeviceNoise noise(syntheticTextonBundle(texton), mapping);
      for (const bool isPoisson : {false, true})
        for (const std::uint32_t mip : {0u, 1u, 2u}) {
          MaterialUse use = noise.host.use();
          use.parameters.pointProcess =
              isPoisson ? LICHEN_POINT_PROCESS_POISSON : LICHEN_POINT_PROCESS_STRATIFIED;
          use.placement.tileOrigin[0] = isPoisson ? 5 : 0;
          if (mapping == Mapping::uv) {
            setPeriod(use, 2.0, 1.0);
          } else {
            use.parameters.rotation = order == 3 ? 0.4 : 0.0;
            use.parameters.scale = mip == 2 ? 1.7 : 1.0;
            use.placement.tileOrigin[1] = 12;
            use.placement.tileOrigin[2] = -5;
          }
          INFO(nameOf(mapping) << ", order " << order << ", steps " << steps << ", mip " << mip);
          // In the plane, 30 impacts at coordinates of 100 texels, rounded to 2^-17, with slopes up
          // to 0.2 per texel: less than 5e-5. On a surface, 60 impacts at positions of 200 texels,
          // rounded in each of three steps: less than 1e-4, and the level's logarithm as much
          // again. Order 0 and the steps of a mix have borders, where rounding may select another
          // texton.
          CHECK(strangersOf(
                    noise, mapping, mip, use, pointsAtMip(texton, mip, use.parameters.scale, 20),
                    mapping == Mapping::uv ? 1e-4 : 3e-4) <= (order == 0 || steps > 1 ? 1u : 0u));
        }
    }
}

TEST_CASE("derivatives are differences over a texel, and a mix's include the mean's slope") {
  for (const int steps : {1, 3}) {
    DeviceNoise noise(
        syntheticTextonBundle({.order = 3, .steps = steps, .channels = 1, .wholeFloats = true}));
    std::vector<SamplePoint> points = samplePoints(200);
    for (SamplePoint& point : points)
      point.plane.gradientX = point.plane.gradientY = {};
    MaterialUse use = noise.host.use();
    setPeriod(use, 2.0, 2.0);
    const auto gradients = noise.drawn(kGradient, use, points);
    const TextonReference reference(noise.bundle, noise.host.material());
    const NoiseMap& map = noise.bundle.noises[0].maps[0];
    // The means of the three steps lie on a line.
    const auto& later = map.as<TextonMap>().laterSteps;
    const double meanSlope = steps == 1 ? 0.0 : later[1].mean[0] - map.mean[0];
    REQUIRE(meanSlope == Approx(steps == 1 ? 0.0 : -0.2)); // fifteen tolerances
    REQUIRE((steps == 1 || later[0].mean[0] == Approx(map.mean[0] + 0.5 * meanSlope)));
    const shader::LichenNoise& constants = noise.host.constants().noise;
    const double texelsX = double(constants.tileTexelsX), texelsY = double(constants.tileTexelsY);
    const double x = 0.5 / texelsX, y = 0.5 / texelsY; // half a texel [tiles]
    for (std::size_t k = 0; k < points.size(); ++k) {
      const TileFootprint at = noise.onPlane(points[k].plane);
      const auto valueAt = [&](double awayX, double awayY) {
        MixPlace mix = points[k].mix;
        mix.weight += mix.gradient[0] * float(awayX) + mix.gradient[1] * float(awayY);
        const Vec sum = reference.inPlane(double(at.position[0]) + awayX,
                                          double(at.position[1]) + awayY, 0, mix);
        const double mean = map.mean[0] + meanSlope * std::clamp(double(mix.weight), 0.0, 1.0);
        return std::clamp(mean + sum[0], 0.0, 1.0); // of a height
      };
      const std::array expected{valueAt(0.0, 0.0), (valueAt(x, 0.0) - valueAt(-x, 0.0)) * texelsX,
                                (valueAt(0.0, y) - valueAt(0.0, -y)) * texelsY};
      const std::array tolerances{1e-4, 2.0 * texelsX * 1e-4, 2.0 * texelsY * 1e-4};
      for (std::size_t c = 0; c < 3; ++c) {
        // Values are within 1e-4. An impact keeps its texton at any point, because the weight is
        // linear. Rounding changes the texton of one of 5 * 6000 impacts if its weight is within
        // 1e-7 of one of two borders between steps: once in 120 such tests.
        INFO("steps " << steps << ", point " << k << ", component " << c);
        CHECK(double(gradients[k][c]) == Approx(expected[c]).margin(tolerances[c]));
      }
    }
  }
}

TEST_CASE("a constant or a direction of the weight follows the material, not the noise's "
          "placement") {
  BundleFile file = syntheticTextonBundle({.order = 1, .steps = 5});
  MixWeight& mix = file.bundle.materials[0]->mix;
  Mapping mapping = Mapping::uv;
  SECTION("a constant") { mix.weight = 0.3; }
  SECTION("a constant on a surface") {
    mix.weight = 0.6;
    mapping = Mapping::surface;
  }
  SECTION("a direction") {
    mix.source = MixSource::direction;
    mix.start = {0.5, -2.0};
    mix.end = {3.0, 1.0};
  }
  DeviceNoise noise(file, mapping);
  MaterialUse use = noise.host.use();
  use.parameters.scale = 0.8;
  use.parameters.rotation = 0.6;
  use.parameters.offset[0] = 2.25;
  use.placement.tileOrigin[0] = 2;
  use.placement.tileOrigin[1] = -1;
  std::vector<SamplePoint> points = samplePoints(200);
  for (SamplePoint& point : points)
    point.hasMix = false;
  const auto gaussians = noise.drawnGaussian(use, points);
  // Texture coordinates are tile coordinates times the scale, rotated.
  const double cosine = use.parameters.scale * std::cos(use.parameters.rotation),
               sine = use.parameters.scale * std::sin(use.parameters.rotation);
  const std::array way{mix.end[0] - mix.start[0], mix.end[1] - mix.start[1]};
  const double square = way[0] * way[0] + way[1] * way[1];
  // The weight knows the whole tiles of the host's origin, which its texture coordinates leave out.
  const std::array origin{2.0 * cosine + sine, 2.0 * sine - cosine};
  Differences onDevice, inCpp;
  for (std::size_t k = 0; k < points.size(); ++k) {
    SamplePoint& p = points[k];
    const auto computed = noise.gaussian(p).value; // at the material's own weight
    p.hasMix = true;
    p.mix = {float(mix.weight), {}};
    if (mix.source == MixSource::direction) {
      const double along = (double(p.plane.uv[0]) + origin[0] - mix.start[0]) * way[0] +
                           (double(p.plane.uv[1]) + origin[1] - mix.start[1]) * way[1];
      p.mix = {float(along / square),
               {float((way[0] * cosine + way[1] * sine) / square),
                float((way[1] * cosine - way[0] * sine) / square)}};
    }
    const auto expected = noise.gaussian(p).value;
    onDevice.add(gaussians[k].value, expected, 3);
    inCpp.add(computed, expected, 3);
  }
  // Weights are below 4, from at most ten roundings of 2^-23. With 6000 impacts and four borders
  // between steps, 0.06 impacts get another texton. Two such points occur once in 600 runs.
  CHECK(onDevice.beyond <= 3); // channels of one point
  CHECK(inCpp.beyond <= 3);
}
