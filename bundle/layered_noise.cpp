// SPDX-License-Identifier: MIT
// Layered noises: which noises fit together, and which mappings they have.
#include "findings.h"
#include "methods/method_parameters.h"

#include <lichen/layered_noise.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lichen {
namespace {

/// The quantile of the standard Gaussian distribution at `share`, by bisection.
double gaussianQuantile(double share) {
  constexpr int kSteps = 60;
  double low = -8.0, high = 8.0;
  for (int step = 0; step < kSteps; ++step) {
    const double middle = 0.5 * (low + high);
    const double below = 0.5 * std::erfc(-middle / std::numbers::sqrt2);
    (below < share ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Sets the side of a node on which each layer below it lies, and the sides of its own nodes.
void setSides(const NoiseLayers& layers, std::size_t node, std::uint32_t path,
              std::array<std::uint32_t, LICHEN_MAX_LAYERS>& sides) {
  const auto follow = [&](const LayerSide& side, std::uint32_t bits) {
    const std::uint32_t extended = path | (bits << (2 * node));
    if (side.isNode)
      setSides(layers, side.index, extended, sides);
    else
      sides[side.index] = extended;
  };
  follow(layers.nodes[node].below, 1);
  follow(layers.nodes[node].above, 2);
}

/// The targets that so many layers may have, so that their images fit into the slots.
std::vector<MapTarget> targetsOf(std::size_t layers) {
  std::vector<MapTarget> targets{MapTarget::baseColor, MapTarget::normal,
                                 MapTarget::occlusionRoughnessMetallic};
  targets.resize(layers == 2 ? 3 : layers == 3 ? 2 : 1);
  return targets;
}

bool hasSameMaps(const Noise& a, const Noise& b) {
  return a.maps.size() == b.maps.size() && std::ranges::all_of(a.maps, [&](const NoiseMap& map) {
           const std::optional<std::size_t> other = findMap(b, map.target);
           return other && b.maps[*other].channels == map.channels;
         });
}

double aspectOf(const Bundle& bundle, const Noise& noise) {
  const auto [width, height] = tileSize(bundle, noise);
  return double(width) / double(height);
}

bool areAlike(double a, double b) {
  constexpr double kTolerance = 0.01; // a stretch that nobody sees
  return std::abs(a - b) <= kTolerance * std::max(a, b);
}

/// What is wrong with a layer or index noise beside the first layer, but for its maps, or nothing.
std::string faultOf(const Bundle& firstBundle, const Noise& first, const Bundle& bundle,
                    const Noise& noise) {
  const std::string name = "the noise " + quoted(noise.name);
  if (&noise != &first && noise.layers)
    return name + " is layered itself; expected one that is not";
  if (isMix(noise))
    return name + " is a mix; expected one that is not";
  if (!parametersOf(noise).isLayerable)
    return name + " has the method " + std::string(nameOf(noise.method())) +
           ", which layers do not take; expected " + layerableMethods();
  if (!areAlike(noise.tileSizeMetres, first.tileSizeMetres))
    return name + " has tiles of " + std::to_string(noise.tileSizeMetres) + " m; expected " +
           std::to_string(first.tileSizeMetres) + " m, as " + quoted(first.name) + " has";
  if (!areAlike(aspectOf(bundle, noise), aspectOf(firstBundle, first)))
    return name + " has tiles of another shape than " + quoted(first.name) +
           "; expected the same width over height";
  return {};
}

} // namespace

bool isLayerable(Method method) { return parametersOf(method).isLayerable; }

std::string layerableMethods() {
  std::vector<std::string> names;
  for (const Method method : allMethods())
    if (isLayerable(method))
      names.emplace_back(nameOf(method));
  std::string text;
  for (std::size_t n = 0; n < names.size(); ++n)
    text += (n == 0 ? "" : n + 1 == names.size() ? " or " : ", ") + names[n];
  return text;
}

std::string layerFault(const Bundle& firstBundle, const Noise& first, const Bundle& bundle,
                       const Noise& noise) {
  if (std::string fault = faultOf(firstBundle, first, bundle, noise); !fault.empty())
    return fault;
  if (!hasSameMaps(first, noise))
    return "the noises " + quoted(first.name) + " and " + quoted(noise.name) +
           " have different maps or channels; expected the same";
  return {};
}

std::string layerTargetFault(std::size_t layers, MapTarget target) {
  const std::vector<MapTarget> targets = targetsOf(layers);
  if (std::ranges::count(targets, target) > 0)
    return {};
  std::string expected;
  for (const MapTarget each : targets)
    expected += (expected.empty() ? "" : ", ") + std::string(nameOf(each));
  return std::to_string(layers) + " layers with the map " + std::string(nameOf(target)) +
         " need more than the 16 images of a shader stage; expected only " + expected;
}

std::string layersFault(const Bundle& bundle, std::size_t noise) {
  const Noise& first = bundle.noises[noise];
  const NoiseLayers& layers = *first.layers;
  for (const NoiseMap& map : first.maps)
    if (std::string fault = layerTargetFault(layers.others.size() + 1, map.target); !fault.empty())
      return fault;
  for (const std::size_t layer : layersOf(bundle, noise))
    if (std::string fault = layerFault(bundle, first, bundle, bundle.noises[layer]); !fault.empty())
      return fault;
  for (const LayerNode& node : layers.nodes) {
    const Noise& index = bundle.noises[node.index];
    if (index.layers)
      return "the index map " + quoted(index.name) + " is layered itself; expected one that is not";
    if (std::string fault = faultOf(bundle, first, bundle, index); !fault.empty())
      return fault;
  }
  return {};
}

std::vector<std::size_t> layersOf(const Bundle& bundle, std::size_t noise) {
  std::vector<std::size_t> layers{noise};
  if (const auto& own = bundle.noises[noise].layers)
    layers.insert(layers.end(), own->others.begin(), own->others.end());
  return layers;
}

std::string mappingObstacle(const Bundle& bundle, std::size_t noise, Mapping mapping) {
  std::vector<std::size_t> evaluated{noise};
  visitLayerNoises(bundle.noises[noise], [&](std::size_t other) { evaluated.push_back(other); });
  for (const std::size_t index : evaluated) {
    const Noise& each = bundle.noises[index];
    const std::string misfit = " does not fit the mapping " + std::string(nameOf(mapping));
    if (!mappingFits(each.method(), mapping))
      return "noise '" + each.name + "' of the method " + std::string(nameOf(each.method())) +
             misfit;
    if (const std::string_view obstacle = mappingObstacle(each, mapping); !obstacle.empty())
      return "noise '" + each.name + "'" + misfit + ": " + std::string(obstacle);
    if (each.layers && !mappingFitsLayers(mapping))
      return "noise '" + each.name + "'" + misfit + ": it has layers";
  }
  return {};
}

bool takesTileRotation(const Bundle& bundle, std::size_t noise, std::uint32_t tileRotation) {
  return std::ranges::all_of(layersOf(bundle, noise), [&](std::size_t layer) {
    return takesTileRotation(shaderNoise(bundle, layer), tileRotation);
  });
}

Noise asIndex(Noise noise) {
  noise.maps.resize(1);
  noise.maps[0].encoding = ValueEncoding::index;
  return noise;
}

shader::LichenLayers shaderLayers(const Noise& noise) {
  shader::LichenLayers result{};
  if (!noise.layers)
    return result;
  const NoiseLayers& layers = *noise.layers;
  result.count = shader::uint(layers.others.size() + 1);
  result.nodes = shader::uint(layers.nodes.size());
  std::array<float, LICHEN_MAX_LAYERS> thresholds{}, softnesses{};
  for (std::size_t n = 0; n < layers.nodes.size(); ++n) {
    // A Gaussian value and the transition add up to a deviation of sqrt(1 + softness^2).
    const LayerNode& node = layers.nodes[n];
    thresholds[n] = float(-std::hypot(1.0, node.softness) * gaussianQuantile(node.proportion));
    softnesses[n] = float(node.softness);
  }
  std::array<std::uint32_t, LICHEN_MAX_LAYERS> sides{};
  setSides(layers, 0, 0, sides);
  result.threshold = {thresholds[0], thresholds[1], thresholds[2], 0.0f};
  result.softness = {softnesses[0], softnesses[1], softnesses[2], 0.0f};
  result.sides = {sides[0], sides[1], sides[2], sides[3]};
  return result;
}

std::uint32_t layerSlot(std::size_t layer, std::uint32_t role) {
  constexpr std::uint32_t kSlots[LICHEN_MAX_LAYERS][3] = {{0, 1, 2}, {3, 4, 5}, {2, 5}, {1}};
  return layer == 0 ? role : kSlots[layer][role];
}

} // namespace lichen
