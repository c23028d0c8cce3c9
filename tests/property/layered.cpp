// SPDX-License-Identifier: MIT
// Layered noises: each layer covers its share of the area at every distance, and transitions keep
// the variance.
#include "example_exemplar.h"
#include "layered_example.h"

#include <lichen/bundle_writer.h>
#include <lichen/layered_noise.h>
#include <lichen/noise_evaluator.h>
#include <lichen/tiling.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

using namespace lichen;
using namespace lichen::test;

namespace {

constexpr int kTexels = 64;
constexpr int kPoints = 20000; // tiles apart, so that they are independent

/// A noise of grey values about a level; its codes are within half the range of that.
Bundle greyNoise(float level, std::uint64_t seed, float range = 0.2f) {
  MapExemplar map = threeMaterials(kTexels, kTexels, seed);
  for (std::size_t i = 0; i < map.values.size() / 3; ++i)
    map.values[i] = level + range * (map.values[3 * i] - 0.5f);
  map.values.resize(map.values.size() / 3);
  map.encoding = ValueEncoding::linear;
  map.target = MapTarget::occlusionRoughnessMetallic;
  map.channels = {MapChannel::occlusion};
  return bundleOf(bakeTiling("noise", {&map, 1}, {}));
}

double meanOf(const Bundle& layer) { return layer.noises[0].maps[0].mean[0]; }

struct Moments {
  double mean = 0.0, variance = 0.0;
};

/// Over points all over the noise, with a footprint of this side [tiles].
Moments momentsOf(const NoiseEvaluator& noise, float footprint, int points = kPoints) {
  std::mt19937 generator(3u);
  std::uniform_real_distribution<float> tiles(0.0f, 4096.0f);
  Moments sums;
  for (int k = 0; k < points; ++k) {
    const TileFootprint at{
        {tiles(generator), tiles(generator)}, {footprint, 0.0f}, {0.0f, footprint}};
    const double value = noise.evaluate(0, at)[0];
    sums.mean += value;
    sums.variance += value * value;
  }
  sums.mean /= points;
  sums.variance = std::max(0.0, sums.variance / points - sums.mean * sums.mean);
  return sums;
}

std::unique_ptr<const NoiseEvaluator> evaluatorOf(const Bundle& bundle) {
  return NoiseEvaluator::create(bundle, *bundle.materials[0]).value();
}

} // namespace

TEST_CASE("layers have their shares of the area at every distance, whatever the softness") {
  const Bundle dark = greyNoise(0.2f, 1), bright = greyNoise(0.8f, 3);
  const Bundle index = examplePatches(kTexels, kTexels);
  constexpr double kShare = 0.7; // of the dark one
  const double expected = kShare * meanOf(dark) + (1.0 - kShare) * meanOf(bright);
  for (const double softness : {0.01, 0.3, 2.0}) {
    const auto noise = evaluatorOf(layeredExample({dark, bright}, index, {kShare}, softness));
    for (const float footprint : {0.0f, 0.05f, 0.3f, 2.0f, 40.0f}) {
      INFO("softness " << softness << ", footprint " << footprint);
      const Moments moments = momentsOf(*noise, footprint);
      // Four standard errors: one of 16,000 correct results fails. Tables of 8 bits move a mean by
      // up to a thousandth.
      const double error = 4.0 * std::sqrt(moments.variance / kPoints) + 0.001;
      CHECK(std::abs(moments.mean - expected) <= error);
    }
  }
}

TEST_CASE("each layer covers its share of the area within 0.003") {
  const Bundle dark = greyNoise(0.2f, 1, 0.0f), bright = greyNoise(0.8f, 1, 0.0f);
  const Bundle index = examplePatches(kTexels, kTexels);
  constexpr int kMany = 400'000; // a standard error of 0.0008 or less
  for (const double share : {0.1, 0.5})
    for (const float footprint : {0.0f, 0.1f}) {
      const auto noise = evaluatorOf(layeredExample({dark, bright}, index, {share}, 0.1));
      const double found = (0.8 - momentsOf(*noise, footprint, kMany).mean) / 0.6;
      INFO("share " << share << ", found " << found << ", footprint " << footprint);
      CHECK(std::abs(found - share) < 0.003);
    }
}

TEST_CASE("a tree of four layers becomes a side and a threshold for each node") {
  Noise noise;
  noise.layers = NoiseLayers{{1, 2, 3},
                             {{0, 0.5, 0.1, {true, 1}, {true, 2}},
                              {0, 0.2, 0.1, {false, 0}, {false, 1}},
                              {0, 0.7, 0.1, {false, 2}, {false, 3}}}};
  const shader::LichenLayers balanced = shaderLayers(noise);
  CHECK(balanced.count == 4);
  CHECK(balanced.nodes == 3);
  // Bits 2n and 2n + 1 of node n: 1 below, 2 above.
  CHECK(balanced.sides.x == (1u | 1u << 2));
  CHECK(balanced.sides.y == (1u | 2u << 2));
  CHECK(balanced.sides.z == (2u | 1u << 4));
  CHECK(balanced.sides.w == (2u | 2u << 4));
  CHECK(balanced.threshold.x == Approx(0.0).margin(1e-6));
  // The quantile of 0.8, 0.841621, times sqrt(1.01).
  CHECK(balanced.threshold.y == Approx(0.845819).epsilon(1e-5));
}

TEST_CASE("a tree is read as it was made, whatever the order of its layers") {
  std::vector<Bundle> layers;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const MapExemplar map = threeMaterials(kTexels, kTexels, seed);
    layers.push_back(bundleOf(bakeTiling("noise", {&map, 1}, {})));
  }
  const Bundle index = examplePatches(kTexels, kTexels);
  const std::vector<BundledNoise> noises{{&layers[0], 0}, {&layers[1], 0}, {&layers[2], 0}};
  const std::vector<BundledNoise> indices{{&index, 0}, {&index, 0}};
  BundleFile file;
  file.bundle =
      layerNoises("layered", noises, indices,
                  {{0, 0.2, 0.1, {false, 2}, {true, 1}}, {0, 0.6, 0.1, {false, 1}, {false, 0}}})
          .value();
  file.previews.emplace_back();
  file.shape = PreviewShape::none;
  const Bundle read = parseBundle(encodeGlb(file).value(), "layered").value();
  CHECK(read.noises[0] == file.bundle.noises[0]);
  const auto meanOfLayer = [&](std::size_t layer) {
    return read.noises[layersOf(read, 0)[layer]].maps[0].mean;
  };
  CHECK(meanOfLayer(0) == layers[0].noises[0].maps[0].mean);
  CHECK(meanOfLayer(1) == layers[2].noises[0].maps[0].mean); // the first that the tree names
  CHECK(meanOfLayer(2) == layers[1].noises[0].maps[0].mean);
  CHECK(read.noises[0].layers->nodes[1].above == LayerSide{false, 0});
}
