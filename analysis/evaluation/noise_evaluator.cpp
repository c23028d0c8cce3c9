// SPDX-License-Identifier: MIT
// Bundle, material and footprint -> value: by the noise's method, or as a blend of layers.
#define LICHEN_METHODS 1 // layers know no method
#include "method_evaluator.h"
#include "shader_library.h"

#include <lichen/bundle_merge.h>
#include <lichen/layered_noise.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace lichen {
namespace {

using Value = NoiseEvaluator::Value;
using Library = glsl::ShaderLibrary;

glsl::vec4 asVec(const Value& v) { return {v[0], v[1], v[2], v[3]}; }

Value meanOf(const Bundle& bundle, const Noise& noise, std::size_t map) {
  if (noise.maps[map].encoding == ValueEncoding::slope)
    return {};
  return std::bit_cast<Value>(shaderMap(bundle, noise, map).mean);
}

} // namespace

Result<std::unique_ptr<const NoiseEvaluator>>
NoiseEvaluator::create(const Bundle& bundle, const MaterialNoise& material,
                       const Placement& placement, const EvaluationOptions& options) {
  const auto exhausted = [&] {
    return "noise " + std::to_string(material.noise) + ": not enough memory for its tables";
  };
  return withinMemory(exhausted, [&]() -> Result<std::unique_ptr<const NoiseEvaluator>> {
    if (material.noise >= bundle.noises.size())
      return Error{ErrorKind::usage, "noise " + std::to_string(material.noise) +
                                         ": the bundle has " +
                                         std::to_string(bundle.noises.size())};
    const Noise& first = bundle.noises[material.noise];
    if (const std::string obstacle = mappingObstacle(bundle, material.noise, material.mapping);
        !obstacle.empty())
      return Error{ErrorKind::usage, obstacle};
    if (!takesTileRotation(bundle, material.noise, material.tileRotation))
      return Error{ErrorKind::usage, "noise '" + first.name + "': tile rotation " +
                                         std::to_string(material.tileRotation) + "; expected " +
                                         std::string(kTileRotations)};
    const auto layerOf = [&](const Bundle& all, MaterialNoise use, std::size_t noise) {
      use.noise = noise;
      return Layer{
          methodEvaluator(all, noise, options), shaderMaterial(all, use, placement), {}, {}};
    };
    std::unique_ptr<NoiseEvaluator> made(new NoiseEvaluator);
    for (const NoiseMap& map : first.maps)
      made->holdsSlopes_.push_back(map.encoding == ValueEncoding::slope);
    if (!first.layers) {
      made->layers_.push_back(layerOf(bundle, material, material.noise));
      return std::unique_ptr<const NoiseEvaluator>(std::move(made));
    }
    made->choice_ = shaderLayers(first);
    const std::vector<std::size_t> noises = layersOf(bundle, material.noise);
    for (std::size_t k = 0; k < noises.size(); ++k) {
      Layer layer = layerOf(bundle, layerMaterial(material, k), noises[k]);
      const Noise& noise = bundle.noises[noises[k]];
      for (const NoiseMap& map : first.maps) {
        layer.maps.push_back(*findMap(noise, map.target));
        layer.means.push_back(meanOf(bundle, noise, layer.maps.back()));
      }
      made->layers_.push_back(std::move(layer));
    }
    for (std::size_t node = 0; node < first.layers->nodes.size(); ++node) {
      Bundle part;
      const std::size_t noise = placeNoise(part, bundle, first.layers->nodes[node].index, {});
      part.noises[noise] = asIndex(part.noises[noise]);
      made->indices_.push_back(layerOf(part, indexMaterial(material, node), noise));
    }
    return std::unique_ptr<const NoiseEvaluator>(std::move(made));
  });
}

Value NoiseEvaluator::evaluate(std::size_t map, const Footprint& at, const MixPlace& mix) const {
  if (indices_.empty())
    return layers_[0].method->evaluate(map, layers_[0].material, at, mix);
  return layered(map, at);
}

void NoiseEvaluator::evaluate(std::size_t map, std::span<const PlanePoint> points,
                              std::span<Value> values) const {
  if (indices_.empty())
    return layers_[0].method->evaluate(map, layers_[0].material, points, values);
  for (std::size_t k = 0; k < points.size(); ++k)
    values[k] = layered(map, points[k].at);
}

/// What lichenLayeredValue (shaders_glsl/mapping/layered.glsl) makes of images in descriptors.
Value NoiseEvaluator::layered(std::size_t map, const Footprint& at) const {
  Library library;
  const auto choice = std::bit_cast<Library::LichenLayers>(choice_);
  glsl::vec3 above(0.0);
  for (std::size_t node = 0; node < indices_.size(); ++node) {
    const int n = int(node);
    const Value index = indices_[node].method->evaluate(0, indices_[node].material, at);
    above[n] = library.lichenIndexWeight(asVec(index), choice.threshold[n], choice.softness[n]);
  }
  const glsl::vec4 weights = library.lichenLayerWeights(above, choice);
  Library::LichenLayerSum sum = library.lichenNoLayers();
  for (std::size_t k = 0; k < layers_.size(); ++k) {
    const Layer& layer = layers_[k];
    if (const glsl::Float weight = weights[int(k)]; weight > 0.0)
      library.lichenAddLayer(sum, weight,
                             asVec(layer.method->evaluate(layer.maps[map], layer.material, at)),
                             asVec(layer.means[map]));
  }
  glsl::vec4 linear(0.0); // variances are averaged
  if (holdsSlopes_[map])
    linear = std::holds_alternative<TileFootprint>(at) ? glsl::vec4(0.0, 0.0, 1.0, 1.0)
                                                       : glsl::vec4(0.0, 0.0, 0.0, 1.0);
  glsl::vec4 value = library.lichenLayered(sum, linear);
  if (!holdsSlopes_[map])
    value = max(value, 0.0);
  return {value.x.v, value.y.v, value.z.v, value.w.v};
}

Value NoiseEvaluator::evaluateUv(std::size_t map, const UvFootprint& at) const {
  Library library;
  const Layer& first = layers_[0];
  const auto material = std::bit_cast<Library::LichenMaterial>(first.material.material);
  const auto toTile = [&](const std::array<float, 2>& uv) {
    const glsl::vec2 tile = library.lichenUvToTile({uv[0], uv[1]}, material);
    return std::array{tile.x.v, tile.y.v};
  };
  const TileFootprint tile{toTile(at.uv), toTile(at.dx), toTile(at.dy)};
  Value value = evaluate(map, tile, first.method->mixAt(first.material, at.uv));
  if (holdsSlopes_[map]) {
    const glsl::vec2 slopes = library.lichenSlopesToUv({value[0], value[1]}, material);
    value[0] = slopes.x.v;
    value[1] = slopes.y.v;
  }
  return value;
}

} // namespace lichen
