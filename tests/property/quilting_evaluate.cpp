// SPDX-License-Identifier: MIT
// Positions of quilting: far away, across tile origins, and in a period.
#include "example_exemplar.h"

#include <lichen/quilting.h>
#include <lichen/synthesize.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <evaluation/method_evaluator.h>
#include <random>

using namespace lichen;

namespace {

constexpr int kSide = 128;

struct Kind {
  bool hasOffsets; ///< otherwise tiles are taken from anywhere
  Grain grain;
};
constexpr Kind kKinds[] = {
    {false, Grain::none}, {true, Grain::none}, {false, Grain::x}, {true, Grain::y}};

Bundle quiltingOf(const Kind& kind) {
  const auto baked = [](double guide) {
    const MapExemplar map = test::threeMaterials(kSide, kSide, 11);
    QuiltingOptions options;
    options.bits = 16;
    options.guide = guide;
    Result<QuiltingBake> bake = bakeQuilting("example", {&map, 1}, options);
    REQUIRE(bake);
    Bundle bundle;
    bundle.tables = std::move(bake.value().tables);
    bundle.noises = {std::move(bake.value().noise)};
    return bundle;
  };
  static const Bundle anywhere = baked(0.0), listed = baked(1.0);
  Bundle bundle = kind.hasOffsets ? listed : anywhere;
  REQUIRE(bundle.noises[0].as<QuiltingNoise>().offsets.empty() != kind.hasOffsets);
  bundle.noises[0].as<QuiltingNoise>().grain = kind.grain;
  return bundle;
}

LinearImage windowOf(const Kind& kind, std::array<double, 2> origin, int width, int height) {
  SynthesisOptions options;
  options.width = width;
  options.height = height;
  options.origin = origin;
  Result<LinearImage> image = synthesize(quiltingOf(kind), options);
  REQUIRE(image);
  return std::move(image).value();
}

} // namespace

TEST_CASE("quilting a billion tiles away is that of an origin there, or in a period that nearby") {
  // A billion tiles and three eighths become a tile origin and an offset; for a periodic lattice,
  // whole periods and a remainder. All are binary fractions.
  MaterialNoise far, near;
  far.offset = {1e9 + 0.375, -1e9 + 0.25};
  near.offset = {0.375, 0.25};
  Placement origin, periodic;
  origin.tileOriginX = 1'000'000'000;
  origin.tileOriginY = -1'000'000'000;
  periodic.periodic = true;
  periodic.periodTilesX = periodic.periodTilesY = 2.0;
  for (const Kind& kind : kKinds) {
    const Bundle bundle = quiltingOf(kind);
    const auto evaluator = methodEvaluator(bundle, 0);
    const auto block = [&](const MaterialNoise& material, const Placement& placement) {
      return shaderMaterial(bundle, material, placement);
    };
    int others = 0;
    for (int k = 0; k < 64; ++k) {
      TileFootprint at;
      at.dx = {1.0f / kSide, 0.0f};
      at.dy = {0.0f, 1.0f / kSide};
      at.position = {float(k % 8) / 8.0f, float(k / 8) / 8.0f};
      const auto value = [&](const shader::LichenTriplanarMaterial& use) {
        return evaluator->evaluate(0, use, at);
      };
      REQUIRE(value(block(far, {})) == value(block(near, origin)));
      REQUIRE(value(block(far, periodic)) == value(block(near, periodic)));
      others += value(block(far, {})) != value(block(near, {})) ? 1 : 0;
    }
    CHECK(others > 8); // a short list has the same tiles at many points
  }
}

TEST_CASE("crossing an integer tile origin changes no pixel of quilting, near or far") {
  for (const Kind& kind : kKinds)
    for (const double far : {0.0, 1e7}) {
      // The same position as fraction and as integer, one whole tile apart on each axis.
      const LinearImage first = windowOf(kind, {far + 3.0, -far - 2.0}, 160, 160);
      const LinearImage second = windowOf(kind, {far + 4.0, -far - 1.0}, 32, 32);
      // A lattice coordinate below 6 has some five roundings of at most 2^-22, and so has each of
      // two heights of tiles. Cuts multiply their difference by 16 and divide by the sum of the
      // weights, taken as 1/2: it is less only near where three tiles meet. Values differ by at
      // most 1.
      for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x)
          for (int c = 0; c < 3; ++c)
            REQUIRE(first.pixel(x + 128, y + 128)[c] ==
                    Approx(second.pixel(x, y)[c]).margin(5.0 * 2.0 * 16.0 * 2.0 / 4194304.0));
    }
}

TEST_CASE("quilting in a period of whole exemplars, or of others, repeats after it") {
  for (const Kind& kind : kKinds) {
    const Bundle bundle = quiltingOf(kind);
    const auto evaluator = methodEvaluator(bundle, 0);
    for (const auto& [periodX, periodY] : {std::pair{2.0, 3.0}, {1.0, 1.0}, {1.375, 2.25}}) {
      Placement placement;
      placement.periodic = true;
      placement.periodTilesX = periodX;
      placement.periodTilesY = periodY;
      const shader::LichenTriplanarMaterial material = shaderMaterial(bundle, {}, placement);
      const shader::LichenTriplanarMaterial open = shaderMaterial(bundle, {}, {});
      std::mt19937 generator(3u);
      std::uniform_real_distribution<float> tiles(0.0f, 1.0f);
      double most = 0.0, mostOpen = 0.0;
      for (int k = 0; k < 400; ++k) {
        TileFootprint at;
        at.dx = {1.0f / kSide, 0.0f};
        at.dy = {0.0f, 1.0f / kSide};
        // Whole texels over 16: exact, also a period further.
        at.position = {std::round(2048.0f * tiles(generator)) / 2048.0f,
                       std::round(2048.0f * tiles(generator)) / 2048.0f};
        TileFootprint right = at, down = at;
        right.position[0] += float(periodX);
        down.position[1] += float(periodY);
        const auto differ = [&](const shader::LichenTriplanarMaterial& use,
                                const TileFootprint& there) {
          const auto a = evaluator->evaluate(0, use, at), b = evaluator->evaluate(0, use, there);
          double difference = 0.0;
          for (std::size_t c = 0; c < 3; ++c)
            difference = std::max(difference, std::abs(double(a[c]) - double(b[c])));
          return difference;
        };
        most = std::max({most, differ(material, right), differ(material, down)});
        mostOpen = std::max({mostOpen, differ(open, right), differ(open, down)});
      }
      INFO("offsets " << kind.hasOffsets << ", grain " << nameOf(kind.grain) << ", periods "
                      << periodX << " and " << periodY);
      CHECK(most < 1e-3);
      CHECK(mostOpen > 0.1);
    }
  }
}
