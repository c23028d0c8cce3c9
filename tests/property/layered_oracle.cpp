// SPDX-License-Identifier: MIT
// Layered noises against an oracle in double precision: "Layered noise" of
// docs/gltf_extension/README.md, from values of the layers and of the index maps, each evaluated as
// a noise of its own.
#include "gaussian_reader.h"
#include "layered_example.h"
#include "oracle_footprints.h"
#include "synthetic_texton.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace lichen;
using namespace lichen::test;

namespace {

using Evaluator = std::unique_ptr<const NoiseEvaluator>;
using Tree = std::vector<LayerNode>;

constexpr LayerSide layer(std::size_t index) { return {false, index}; }
constexpr LayerSide node(std::size_t index) { return {true, index}; }
const std::vector<Tree> kTrees{
    {{0, 0.4, 0.3, layer(0), layer(1)}},
    {{0, 0.3, 0.05, node(1), layer(2)}, {0, 0.6, 1.0, layer(0), layer(1)}},
    {{0, 0.5, 0.1, node(1), node(2)},
     {0, 0.2, 0.2, layer(0), layer(1)},
     {0, 0.7, 2.0, layer(2), layer(3)}},
    {{0, 0.7, 0.5, layer(0), node(1)},
     {0, 0.6, 0.3, layer(1), node(2)},
     {0, 0.5, 0.2, layer(2), layer(3)}}};

constexpr Placement kPlacement{.tileOriginX = 5, .tileOriginY = -3, .tileOriginZ = 2};
MaterialNoise materialWith(Mapping mapping, std::uint32_t part = 0) {
  MaterialNoise material;
  material.mapping = mapping;
  material.seed = 7u + 0x9E3779B9u * part;
  material.scale = 0.8;
  material.rotation = 0.4;
  material.offset = {0.25, -1.5};
  material.contrast = 1.3;
  material.planeSharpness = 3.0;
  return material;
}

const Bundle& index() {
  static const Bundle bundle = examplePatches(64, 48);
  return bundle;
}

Evaluator layered(const std::vector<Bundle>& layers, const Tree& tree, Mapping mapping) {
  std::vector<BundledNoise> noises;
  for (const Bundle& bundle : layers)
    noises.push_back({&bundle, 0});
  const std::vector<BundledNoise> indices(tree.size(), {&index(), 0});
  return NoiseEvaluator::create(layerNoises("layered", noises, indices, tree).value(),
                                materialWith(mapping), kPlacement)
      .value();
}

/// Layers of one color each: the value of a layered noise is the weights of the first three.
std::vector<Bundle> colors(std::size_t count) {
  std::vector<Bundle> layers(count, syntheticTextonBundle({}).bundle);
  for (std::size_t k = 0; k < count; ++k) {
    NoiseMap& map = layers[k].noises[0].maps[0];
    map.mean = {double(k == 0), double(k == 1), double(k == 2)};
    map.as<TextonMap>().scale.assign(3, 0.0);
  }
  return layers;
}

/// The weights of all layers on a side of the tree, whose weight is `weight`.
void weigh(const Tree& tree, const LayerSide& side, double weight, const Eigen::Vector3d& above,
           Eigen::Vector4d& weights) {
  if (!side.isNode) {
    weights[Eigen::Index(side.index)] = weight;
    return;
  }
  const double share = above[Eigen::Index(side.index)];
  weigh(tree, tree[side.index].below, weight * (1.0 - share), above, weights);
  weigh(tree, tree[side.index].above, weight * share, above, weights);
}

double normalCdf(double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }
double normalQuantile(double share) {
  double low = -9.0, high = 9.0;
  while (high - low > 1e-12)
    (normalCdf(0.5 * (low + high)) < share ? low : high) = 0.5 * (low + high);
  return low;
}

template <class Act>
void atFootprints(Mapping mapping, const Act& act) {
  for (const TriplanarFootprint& at : oracleFootprints(200))
    if (mapping == Mapping::triplanar)
      act(at);
    else
      act(onTiles(at));
}

} // namespace

TEST_CASE("the weights of layers are products of Gaussian transitions of the index maps") {
  for (const Mapping mapping : {Mapping::uv, Mapping::triplanar})
    for (const Tree& tree : kTrees) {
      const Evaluator evaluator = layered(colors(tree.size() + 1), tree, mapping);
      std::vector<GaussianReader> indices;
      for (std::uint32_t n = 0; n < tree.size(); ++n) {
        MaterialNoise own = materialWith(mapping, 4 + n);
        own.contrast = 1.0;
        indices.emplace_back(index(), own, kPlacement);
      }
      double most = 0.0;
      atFootprints(mapping, [&](const auto& at) {
        Eigen::Vector3d above = Eigen::Vector3d::Zero();
        for (std::size_t n = 0; n < tree.size(); ++n) {
          const GaussianReading own = indices[n].at(at);
          const double s = tree[n].softness;
          const double t = std::sqrt(1.0 + s * s) * normalQuantile(1.0 - tree[n].proportion);
          above[Eigen::Index(n)] = normalCdf((own.z[0] - t) / std::sqrt(s * s + own.lost[0]));
        }
        Eigen::Vector4d weights = Eigen::Vector4d::Zero();
        weigh(tree, node(0), 1.0, above, weights);
        const auto found = evaluator->evaluate(0, at);
        for (std::size_t k = 0; k < 3; ++k)
          most = std::max(most, std::abs(double(found[k]) - weights[Eigen::Index(k)]));
      });
      INFO(nameOf(mapping) << ", " << tree.size() + 1 << " layers");
      // The format lets a share of a node be off by 0.0024. Shares are at most 1, so a product of n
      // of them is off by at most n times as much; floats round by less than 1e-4.
      CHECK(most < 0.0024 * double(tree.size()) + 1e-4);
    }
}

TEST_CASE("layers are blended about their means with their variance, and variances of slopes are "
          "averaged") {
  const auto [mapping, channels, tree] =
      GENERATE(table<Mapping, int, std::size_t>({{Mapping::uv, 3, 0},
                                                 {Mapping::uv, 3, 3},
                                                 {Mapping::uv, 2, 0},
                                                 {Mapping::uv, 2, 1},
                                                 {Mapping::triplanar, 3, 2},
                                                 {Mapping::triplanar, 2, 1}}));
  const bool isSlope = channels == 2;
  const std::size_t count = kTrees[tree].size() + 1;
  std::vector<Bundle> layers(count, syntheticTextonBundle({.channels = channels}).bundle);
  std::vector<double> means;
  std::vector<Evaluator> parts;
  for (std::size_t k = 0; k < count; ++k) {
    NoiseMap& map = layers[k].noises[0].maps[0];
    const double mean = 0.2 + 0.1 * double(k); // some values are clamped at 0
    map.mean.assign(std::size_t(channels), mean);
    map.as<TextonMap>().scale.assign(std::size_t(channels), 6.0 * 0.2);
    means.push_back(isSlope ? 0.0 : mean * mean + 0.04);
    parts.push_back(
        NoiseEvaluator::create(layers[k], materialWith(mapping, std::uint32_t(k)), kPlacement)
            .value());
  }
  const Evaluator evaluator = layered(layers, kTrees[tree], mapping);
  const Evaluator weigher = layered(colors(count), kTrees[tree], mapping);
  // Two slopes, or three in space, and their variance.
  const std::size_t variance = !isSlope ? 3 : mapping == Mapping::uv ? 2 : 3;
  double most = 0.0;
  atFootprints(mapping, [&](const auto& at) {
    const auto shares = weigher->evaluate(0, at);
    Eigen::Vector4d weights{double(shares[0]), double(shares[1]), double(shares[2]), 0.0};
    weights[3] = count == 4 ? 1.0 - weights.sum() : 0.0;
    const auto found = evaluator->evaluate(0, at);
    for (std::size_t c = 0; c < variance + (isSlope ? 1 : 0); ++c) {
      double sum = 0.0;
      for (std::size_t k = 0; k < count; ++k) {
        const double value = double(parts[k]->evaluate(0, at)[c]);
        sum += weights[Eigen::Index(k)] *
               (c == variance ? value : means[k] + (value - means[k]) / weights.norm());
      }
      most = std::max(most, std::abs(double(found[c]) - (isSlope ? sum : std::max(sum, 0.0))));
    }
  });
  INFO(nameOf(mapping) << ", channels " << channels << ", " << count << " layers");
  // Weights and values are rounded by a few 2^-24, and gains are at most 2.
  CHECK(most < 1e-6);
}
