// SPDX-License-Identifier: MIT
// Index maps -> weights of the layers; values of the layers -> their blend. Steps and names follow
// shaders_glsl/noise/layers.glsl.
#include "layered_evaluator.h"

#include "gaussianization/polynomial_cdf.h"
#include "method_analysis.h"

#include <lichen/bundle_merge.h>
#include <lichen/layered_noise.h>

#include <algorithm>
#include <cmath>

namespace lichen {
namespace {

using Value = NoiseEvaluator::Value;
using Weights = std::array<float, LICHEN_MAX_LAYERS>;

/// lichenIndexWeight.
float indexWeight(const Value& index, float threshold, float softness) {
  const float z = 6.0f * (index[0] - 0.5f);
  const float deviation = std::sqrt(softness * softness + std::max(index[3], 0.0f));
  constexpr float kLeast = 0.0022f;
  const float below = gaussianization::polynomialCdf(0.5f + (z - threshold) / (6.0f * deviation));
  return std::clamp((below - kLeast) / (1.0f - 2.0f * kLeast), 0.0f, 1.0f);
}

/// The sum of layers about their means.
class LayerSum {
public:
  /// lichenAddLayer.
  void add(float weight, const Value& value, const Value& mean) {
    for (std::size_t c = 0; c < value.size(); ++c) {
      means_[c] += weight * mean[c];
      rest_[c] += weight * (value[c] - mean[c]);
    }
    squares_ += weight * weight;
  }
  /// lichenLayered. Components from `linear` on are averaged, such as variances.
  [[nodiscard]] Value value(std::size_t linear) const {
    const float gain = 1.0f / std::sqrt(squares_);
    Value result{};
    for (std::size_t c = 0; c < result.size(); ++c)
      result[c] = means_[c] + (c >= linear ? 1.0f : gain) * rest_[c];
    return result;
  }

private:
  Value means_{}, rest_{};
  float squares_ = 0.0f;
};

class LayeredEvaluator final : public NoiseEvaluator {
public:
  struct Layer {
    std::unique_ptr<const NoiseEvaluator> evaluator;
    std::vector<std::size_t> maps; ///< of the layer, by map of the first one
    std::vector<Value> means;      ///< by map of the first layer; 0 of slopes
  };

  LayeredEvaluator(const Noise& noise, const shader::LichenTriplanarMaterial& constants,
                   std::vector<Layer> layers,
                   std::vector<std::unique_ptr<const NoiseEvaluator>> indices)
      : NoiseEvaluator(noise, constants), constants_(shaderLayers(noise)),
        layers_(std::move(layers)), indices_(std::move(indices)) {}

  [[nodiscard]] Value evaluate(std::size_t map, const TileFootprint& at,
                               const MixPlace&) const override {
    return blended(map, at, 2);
  }
  [[nodiscard]] Value evaluate(std::size_t map, const TriplanarFootprint& at,
                               const MixPlace&) const override {
    return blended(map, at, 3);
  }
  [[nodiscard]] Value evaluate(std::size_t map, const SurfaceFootprint& at,
                               const MixPlace&) const override {
    return blended(map, at, 2);
  }
  [[nodiscard]] Value evaluate(std::size_t map, const SolidFootprint& at) const override {
    return blended(map, at, 3);
  }

private:
  template <class Footprint>
  [[nodiscard]] Weights weightsAt(const Footprint& at) const {
    const std::array thresholds{constants_.threshold.x, constants_.threshold.y,
                                constants_.threshold.z};
    const std::array softnesses{constants_.softness.x, constants_.softness.y,
                                constants_.softness.z};
    const std::array sides{constants_.sides.x, constants_.sides.y, constants_.sides.z,
                           constants_.sides.w};
    Weights weights{};
    std::fill_n(weights.begin(), layers_.size(), 1.0f);
    for (std::size_t n = 0; n < indices_.size(); ++n) {
      const float above = indexWeight(indices_[n]->evaluate(0, at), thresholds[n], softnesses[n]);
      for (std::size_t layer = 0; layer < layers_.size(); ++layer) {
        const std::uint32_t side = (sides[layer] >> (2 * n)) & 3u;
        weights[layer] *= side == 1 ? 1.0f - above : side == 2 ? above : 1.0f;
      }
    }
    return weights;
  }

  /// `variance` is the component of slopes from which on they are no slopes.
  template <class Footprint>
  [[nodiscard]] Value blended(std::size_t map, const Footprint& at, std::size_t variance) const {
    const Weights weights = weightsAt(at);
    LayerSum sum;
    for (std::size_t layer = 0; layer < layers_.size(); ++layer)
      if (weights[layer] > 0.0f)
        sum.add(weights[layer], layers_[layer].evaluator->evaluate(layers_[layer].maps[map], at),
                layers_[layer].means[map]);
    if (holdsSlopes(map))
      return sum.value(variance);
    Value value = sum.value(4);
    for (float& component : value)
      component = std::max(component, 0.0f);
    return value;
  }

  shader::LichenLayers constants_;
  std::vector<Layer> layers_;
  std::vector<std::unique_ptr<const NoiseEvaluator>> indices_;
};

Value meanOf(const Bundle& bundle, const Noise& noise, std::size_t map) {
  if (noise.maps[map].encoding == ValueEncoding::slope)
    return {};
  const shader::vec4 mean = shaderMap(bundle, noise, map).mean;
  return {mean.x, mean.y, mean.z, mean.w};
}

} // namespace

Result<std::unique_ptr<const NoiseEvaluator>> layeredEvaluator(const Bundle& bundle,
                                                               const MaterialNoise& material,
                                                               const Placement& placement,
                                                               const EvaluationOptions& options) {
  const auto evaluatorOf = [&](const Bundle& all, MaterialNoise part, std::size_t noise) {
    part.noise = noise;
    return analysisOf(all.noises[noise].method()).evaluator(all, part, placement, options);
  };
  const Noise& first = bundle.noises[material.noise];
  const std::vector<std::size_t> noises = layersOf(bundle, material.noise);
  std::vector<LayeredEvaluator::Layer> layers;
  for (std::size_t layer = 0; layer < noises.size(); ++layer) {
    auto evaluator = evaluatorOf(bundle, layerMaterial(material, layer), noises[layer]);
    if (!evaluator)
      return evaluator.error();
    LayeredEvaluator::Layer made{std::move(evaluator).value(), {}, {}};
    const Noise& noise = bundle.noises[noises[layer]];
    for (const NoiseMap& map : first.maps) {
      made.maps.push_back(*findMap(noise, map.target));
      made.means.push_back(meanOf(bundle, noise, made.maps.back()));
    }
    layers.push_back(std::move(made));
  }
  std::vector<std::unique_ptr<const NoiseEvaluator>> indices;
  for (std::size_t node = 0; node < first.layers->nodes.size(); ++node) {
    const std::size_t noise = first.layers->nodes[node].index;
    Bundle part;
    const std::size_t place = placeNoise(part, bundle, noise, {});
    part.noises[place] = asIndex(part.noises[place]);
    auto evaluator = evaluatorOf(part, indexMaterial(material, node), place);
    if (!evaluator)
      return evaluator.error();
    indices.push_back(std::move(evaluator).value());
  }
  return std::unique_ptr<const NoiseEvaluator>(std::make_unique<LayeredEvaluator>(
      first, shaderMaterial(bundle, material, placement), std::move(layers), std::move(indices)));
}

} // namespace lichen
