// SPDX-License-Identifier: MIT
// Positions of the noises of all methods: far away, across tile origins, in a period, and in space.
#include "bundle_of.h"
#include "example_exemplar.h"

#include <lichen/local_random_phase.h>
#include <lichen/multiple_kernels.h>
#include <lichen/quilting.h>
#include <lichen/synthesize.h>
#include <lichen/texton.h>
#include <lichen/tiling.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <evaluation/method_evaluator.h>
#include <random>
#include <string>
#include <vector>

using namespace lichen;
using namespace lichen::test;

namespace {

constexpr int kSide = 64;

// A lattice coordinate below 6 has some five roundings of at most 2^-22. Tiling: this moves two
// weights by 1.2e-6 and G by 4e-6, and as much again through the norm, both over W >= 1 / sqrt(3);
// dU/dG <= 2.4, a unit of U has 32 cells on each of 3 axes, and neighbouring cells differ by at
// most 1. Quilting: each of two heights of tiles has these roundings. Cuts multiply their
// difference by 16 and divide by the sum of the weights, taken as 1/2, since it is less only near
// where three tiles meet; values differ by at most 1. Sums of impacts and of cosines: slopes of 30
// are below 1 per texel, at positions rounded to 2^-17 texels.
constexpr double kOfTiling = 9e-4, kOfQuilting = 5.0 * 2.0 * 16.0 * 2.0 / 4194304.0, kOfSums = 1e-3;

struct Kind {
  std::string name;
  Bundle bundle;
  MaterialNoise material;
  double tolerance;
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all = [] {
    const MapExemplar map = threeMaterials(kSide, kSide, 11);
    TilingOptions fine;
    fine.bits = 16;
    const Bundle tiling = bundleOf(bakeTiling("x", {&map, 1}, fine));
    const auto quilting = [&](double guide, Grain grain) {
      QuiltingOptions options;
      options.bits = 16;
      options.guide = guide;
      Bundle bundle = bundleOf(bakeQuilting("x", {&map, 1}, options));
      REQUIRE(bundle.noises[0].as<QuiltingNoise>().offsets.empty() == (guide == 0.0));
      bundle.noises[0].as<QuiltingNoise>().grain = grain;
      return bundle;
    };
    Bundle grained = tiling;
    grained.noises[0].as<TilingNoise>().grain = Grain::x;
    TextonOptions small;
    small.support = 16;
    const Bundle texton = bundleOf(bakeTexton("x", {&map, 1}, small));
    LocalRandomPhaseOptions plain, half;
    plain.structure = 0.0;
    half.structure = 0.5;
    MultipleKernelsOptions patterned;
    patterned.perturbation = Perturbation{.amount = 0.5, .pattern = {}, .cosines = 20};
    MaterialNoise rotated, turned, poisson;
    rotated.tileRotation = 2;
    turned.tileRotation = 4;
    poisson.pointProcess = PointProcess::poisson;
    return std::vector<Kind>{
        {"tiling", tiling, {}, kOfTiling},
        {"tiling with a grain", grained, {}, kOfTiling},
        {"tiling by half turns", tiling, rotated, kOfTiling},
        {"tiling by quarter turns", tiling, turned, kOfTiling},
        {"quilting", quilting(0.0, Grain::none), {}, kOfQuilting},
        {"quilting with a list of offsets", quilting(1.0, Grain::none), {}, kOfQuilting},
        {"quilting with a grain along x", quilting(0.0, Grain::x), {}, kOfQuilting},
        {"quilting with a list and a grain", quilting(1.0, Grain::y), {}, kOfQuilting},
        {"textons", texton, {}, kOfSums},
        {"textons of a Poisson process", texton, poisson, kOfSums},
        {"cosines", bundleOf(bakeLocalRandomPhase("x", {&map, 1}, plain)), {}, kOfSums},
        {"a structure", bundleOf(bakeLocalRandomPhase("x", {&map, 1}, half)), {}, kOfSums},
        {"kernels", bundleOf(bakeMultipleKernels("x", {&map, 1}, {})), {}, kOfSums},
        {"kernels with a pattern",
         bundleOf(bakeMultipleKernels("x", {&map, 1}, patterned)),
         {},
         kOfSums},
    };
  }();
  return all;
}

/// Decoded where the tolerance says so, else before the table, which amplifies differences.
std::array<float, 3> valueOf(const Kind& kind, const MethodEvaluator& evaluator,
                             const shader::LichenTriplanarMaterial& use, const Footprint& at) {
  if (kind.tolerance == kOfSums)
    return evaluator.gaussian(0, use, at).value;
  const MethodEvaluator::Value value = evaluator.evaluate(0, use, at);
  return {value[0], value[1], value[2]};
}

TileFootprint pixelAt(double x, double y) {
  return {{float(x), float(y)}, {1.0f / kSide, 0.0f}, {0.0f, 1.0f / kSide}};
}

double difference(const std::array<float, 3>& a, const std::array<float, 3>& b) {
  double most = 0.0;
  for (std::size_t c = 0; c < 3; ++c)
    most = std::max(most, std::abs(double(a[c]) - double(b[c])));
  return most;
}

Placement originAt(std::int64_t x, std::int64_t y, std::int64_t z = 0) {
  Placement placement;
  placement.tileOriginX = x;
  placement.tileOriginY = y;
  placement.tileOriginZ = z;
  return placement;
}

} // namespace

TEST_CASE("a noise a billion tiles away equals the noise of an origin there, or in a period the "
          "noise nearby") {
  // A billion tiles and three eighths become a tile origin and an offset; for a periodic lattice,
  // whole periods and a remainder. All are binary fractions.
  Placement periodic;
  periodic.periodic = true;
  periodic.periodTilesX = periodic.periodTilesY = 2.0;
  for (const Kind& kind : kinds()) {
    INFO(kind.name);
    const auto evaluator = methodEvaluator(kind.bundle, 0);
    MaterialNoise far = kind.material, near = kind.material;
    far.offset = {1e9 + 0.375, -1e9 + 0.25};
    near.offset = {0.375, 0.25};
    const auto used = [&](const MaterialNoise& material, const Placement& placement) {
      return shaderMaterial(kind.bundle, material, placement);
    };
    int others = 0;
    for (int k = 0; k < 64; ++k) {
      const auto value = [&](const shader::LichenTriplanarMaterial& use) {
        return valueOf(kind, *evaluator, use, pixelAt(k % 8 / 8.0, double(k / 8) / 8.0));
      };
      REQUIRE(value(used(far, {})) == value(used(near, originAt(1'000'000'000, -1'000'000'000))));
      REQUIRE(value(used(far, periodic)) == value(used(near, periodic)));
      others += value(used(far, {})) != value(used(near, {})) ? 1 : 0;
    }
    CHECK(others > 8); // a short list has the same tiles at many points
  }
}

TEST_CASE("crossing an integer tile origin changes no value, near or far") {
  for (const Kind& kind : kinds())
    for (const std::int64_t far : {0, 10'000'000}) {
      INFO(kind.name << ", " << far << " tiles away");
      const auto evaluator = methodEvaluator(kind.bundle, 0);
      const auto before = shaderMaterial(kind.bundle, kind.material, originAt(far + 3, -far - 2));
      const auto after = shaderMaterial(kind.bundle, kind.material, originAt(far + 4, -far - 1));
      double most = 0.0;
      for (int k = 0; k < 400; ++k) {
        // Centres of texels, as pixels of an image have them.
        const double x = (k % 20 + 0.5) / kSide, y = (double(k / 20) + 0.5) / kSide;
        most =
            std::max(most, difference(valueOf(kind, *evaluator, before, pixelAt(x + 1.0, y + 1.0)),
                                      valueOf(kind, *evaluator, after, pixelAt(x, y))));
      }
      CHECK(most < kind.tolerance);
    }
}

TEST_CASE("a noise in a period of whole exemplars, or of others, repeats after it") {
  for (const Kind& kind : kinds()) {
    const auto evaluator = methodEvaluator(kind.bundle, 0);
    for (const auto& [periodX, periodY] : {std::pair{2.0, 3.0}, {1.0, 1.0}, {1.375, 2.25}}) {
      Placement placement;
      placement.periodic = true;
      placement.periodTilesX = periodX;
      placement.periodTilesY = periodY;
      const auto closed = shaderMaterial(kind.bundle, kind.material, placement);
      const auto open = shaderMaterial(kind.bundle, kind.material, {});
      std::mt19937 generator(3u);
      std::uniform_real_distribution<double> tiles(0.0, 1.0);
      double most = 0.0, mostOpen = 0.0;
      for (int k = 0; k < 200; ++k) {
        // Binary fractions: exact, also a period further.
        const double x = std::round(2048.0 * tiles(generator)) / 2048.0;
        const double y = std::round(2048.0 * tiles(generator)) / 2048.0;
        const auto differ = [&](const shader::LichenTriplanarMaterial& use) {
          const auto here = valueOf(kind, *evaluator, use, pixelAt(x, y));
          return std::max(
              difference(here, valueOf(kind, *evaluator, use, pixelAt(x + periodX, y))),
              difference(here, valueOf(kind, *evaluator, use, pixelAt(x, y + periodY))));
        };
        most = std::max(most, differ(closed));
        mostOpen = std::max(mostOpen, differ(open));
      }
      INFO(kind.name << ", periods " << periodX << " and " << periodY);
      CHECK(most < kind.tolerance);
      CHECK(mostOpen > 0.1);
    }
  }
}

TEST_CASE("a tileable image moved by its origin is the same image, rolled") {
  constexpr int kWidth = 96, kHeight = 72, kShiftX = 40 - 64 * 20, kShiftY = 17;
  for (const Kind& kind : kinds()) {
    INFO(kind.name);
    SynthesisOptions options;
    options.width = kWidth;
    options.height = kHeight;
    options.tileable = true;
    options.material = kind.material;
    const Result<LinearImage> first = synthesize(kind.bundle, options);
    options.origin = {double(kShiftX) / kSide, double(kShiftY) / kSide};
    const Result<LinearImage> moved = synthesize(kind.bundle, options);
    REQUIRE((first && moved));
    double most = 0.0;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        for (int c = 0; c < 3; ++c)
          most = std::max(
              most, std::abs(double(moved.value().pixel(x, y)[c]) -
                             double(first.value().pixel(((x + kShiftX) % kWidth + kWidth) % kWidth,
                                                        (y + kShiftY) % kHeight)[c])));
    CHECK(most < kind.tolerance);
  }
}

TEST_CASE("a noise in space does not depend on the tile origin") {
  struct InSpace {
    const char* kind;
    Mapping mapping;
  };
  std::mt19937 generator(6u);
  std::uniform_real_distribution<float> metres(-0.5f, 0.5f);
  std::normal_distribution<float> gaussian;
  for (const auto& [name, mapping] : {InSpace{"tiling", Mapping::triplanar},
                                      {"tiling by quarter turns", Mapping::triplanar},
                                      {"quilting", Mapping::triplanar},
                                      {"textons", Mapping::triplanar},
                                      {"cosines", Mapping::triplanar},
                                      {"textons", Mapping::surface},
                                      {"kernels", Mapping::surface},
                                      {"cosines", Mapping::solid},
                                      {"kernels", Mapping::solid}}) {
    const Kind& kind = *std::ranges::find(kinds(), name, &Kind::name);
    const auto evaluator = methodEvaluator(kind.bundle, 0);
    for (const double rotation : {0.0, 0.7}) {
      INFO(name << ", " << nameOf(mapping) << ", rotated by " << rotation);
      MaterialNoise material = kind.material;
      material.mapping = mapping;
      material.rotation = rotation;
      material.scale = 0.5; // tiles of half a metre
      const std::int64_t deep = (std::int64_t(1) << 40) - 9;
      const auto near = shaderMaterial(kind.bundle, material, originAt(10000000, -9999999, deep));
      const auto far =
          shaderMaterial(kind.bundle, material, originAt(10000003, -10000001, deep + 7));
      double most = 0.0;
      for (int k = 0; k < 100; ++k) {
        const std::array<float, 3> place{metres(generator), metres(generator), metres(generator)};
        const std::array<float, 3> normal{gaussian(generator), gaussian(generator),
                                          gaussian(generator)};
        const auto at = [&](const std::array<float, 3>& position) -> Footprint {
          if (mapping == Mapping::solid)
            return SolidFootprint{position, {}, {}};
          if (mapping == Mapping::surface) {
            SurfaceFootprint point;
            point.position = position;
            point.normal = {0.6f, 0.0f, 0.8f};
            point.tangent = {0.8f, 0.0f, -0.6f, 1.0f};
            return point;
          }
          TriplanarFootprint point;
          point.position = position;
          point.normal = normal;
          return point;
        };
        most = std::max(
            most, difference(valueOf(kind, *evaluator, far, at(place)),
                             valueOf(kind, *evaluator, near,
                                     at({place[0] + 1.5f, place[1] - 1.0f, place[2] + 3.5f}))));
      }
      // Positions of up to four metres and planes of 2^40 tiles are rounded; values of adjacent
      // texels differ by at most 1.
      CHECK(most < 4e-3);
    }
  }
}
