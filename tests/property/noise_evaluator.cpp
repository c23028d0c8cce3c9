// SPDX-License-Identifier: MIT
// NoiseEvaluator at points: texture coordinates become tiles by the material's affine map, as
// MaterialNoise defines it; slopes rotate with the map; a mix uses the material's weight.
#include "synthetic_noise.h"
#include "synthetic_texton.h"

#include <lichen/noise_evaluator.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

using namespace lichen;
using namespace lichen::test;

namespace {

using Value = NoiseEvaluator::Value;

/// A material that scales, rotates and moves a noise.
MaterialNoise movedMaterial() {
  MaterialNoise material;
  material.scale = 0.4;
  material.rotation = 0.7;
  material.offset = {0.3, 1.6};
  material.seed = 5;
  return material;
}

/// Tile coordinates by the definition of MaterialNoise::scale, without the offset, which the
/// constants store.
TileFootprint onTiles(const MaterialNoise& material, double u, double v) {
  const double cosine = std::cos(material.rotation), sine = std::sin(material.rotation);
  TileFootprint at;
  at.position = {float((cosine * u + sine * v) / material.scale),
                 float((-sine * u + cosine * v) / material.scale)};
  return at;
}

std::unique_ptr<const NoiseEvaluator> evaluatorOf(const Bundle& bundle,
                                                  const MaterialNoise& material) {
  auto created = NoiseEvaluator::create(bundle, material);
  if (!created)
    FAIL(created.error().message);
  return std::move(created).value();
}

void checkSame(const Value& value, const Value& expected) {
  constexpr double kMargin = 2e-3; // positions are floats, and values change by at most 2 per texel
  for (std::size_t c = 0; c < value.size(); ++c)
    CHECK(double(value[c]) == Approx(double(expected[c])).margin(kMargin));
}

const std::vector<std::array<double, 2>> kPoints{{0.0, 0.0}, {0.21, 0.93}, {-1.37, 2.5}, {7.1, -3}};

} // namespace

TEST_CASE(
    "the evaluator applies the material's scale, rotation and offset to texture coordinates") {
  const MaterialNoise material = movedMaterial();
  const Bundle tiling = syntheticBundle(std::vector<SyntheticMap>{{}}).bundle;
  const auto tilingNoise = evaluatorOf(tiling, material);
  const Bundle texton = syntheticTextonBundle({}).bundle;
  const auto textonNoise = evaluatorOf(texton, material);
  for (const auto& [u, v] : kPoints) {
    const UvFootprint at{{float(u), float(v)}, {}, {}};
    const TileFootprint tile = onTiles(material, u, v);
    checkSame(tilingNoise->evaluateUv(0, at), tilingNoise->evaluate(0, tile));
    checkSame(textonNoise->evaluateUv(0, at), textonNoise->evaluate(0, tile));
  }
}

TEST_CASE("slopes rotate against the rotation of the texture coordinates") {
  SyntheticTexton slopes;
  slopes.channels = 2;
  const Bundle bundle = syntheticTextonBundle(slopes).bundle;
  const MaterialNoise material = movedMaterial();
  const auto noise = evaluatorOf(bundle, material);
  const double cosine = std::cos(material.rotation), sine = std::sin(material.rotation);
  for (const auto& [u, v] : kPoints) {
    const Value tile = noise->evaluate(0, onTiles(material, u, v));
    const Value rotated = noise->evaluateUv(0, {{float(u), float(v)}, {}, {}});
    // x' = cos x + sin y, y' = -sin x + cos y with v down: slopes have y up.
    checkSame(rotated,
              {float(cosine * double(tile[0]) + sine * double(tile[1])),
               float(cosine * double(tile[1]) - sine * double(tile[0])), tile[2], tile[3]});
  }
}

TEST_CASE("a mix uses its material's weight, constant or along a direction") {
  SyntheticTexton steps;
  steps.steps = 5;
  const Bundle bundle = syntheticTextonBundle(steps).bundle;
  MaterialNoise material = movedMaterial();
  material.mix = {.weight = 0.8};
  const auto constant = evaluatorOf(bundle, material);
  material.mix = {.source = MixSource::direction, .start = {0.0, 0.0}, .end = {0.0, 2.0}};
  const auto direction = evaluatorOf(bundle, material);
  for (const float u : {0.0f, 0.37f, 2.2f}) {
    checkSame(constant->evaluateUv(0, {{u, 1.6f}, {}, {}}),
              constant->evaluate(0, onTiles(material, double(u), 1.6), {0.8f, {}}));
    // At v = 1.6 of 2 the weight is 0.8; its derivative in tiles is (sin, cos) scale / 2.
    const float rise = float(material.scale / 2.0);
    const MixPlace place{
        0.8f,
        {rise * float(std::sin(material.rotation)), rise * float(std::cos(material.rotation))}};
    checkSame(direction->evaluateUv(0, {{u, 1.6f}, {}, {}}),
              direction->evaluate(0, onTiles(material, double(u), 1.6), place));
  }
}

TEST_CASE("a noise index out of range and a mapping that the method lacks are usage errors") {
  const Bundle bundle = syntheticBundle(std::vector<SyntheticMap>{{}}).bundle;
  MaterialNoise material;
  material.mapping = Mapping::surface;
  const auto unfit = NoiseEvaluator::create(bundle, material);
  REQUIRE_FALSE(unfit.ok());
  CHECK(unfit.error().kind == ErrorKind::usage);
  CHECK(unfit.error().message ==
        "noise 'synthetic' of the method tiling does not fit the mapping surface");
  material.noise = 1;
  const auto absent = NoiseEvaluator::create(bundle, material);
  REQUIRE_FALSE(absent.ok());
  CHECK(absent.error().message == "noise 1: the bundle has 1");
}
