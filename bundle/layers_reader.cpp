// SPDX-License-Identifier: MIT
// Reads the layers of a noise, and checks them against the noises that they name.
#include "extension_reader.h"

#include <lichen/shader_parameters.h>

#include <algorithm>
#include <cmath>

namespace lichen {
namespace {

using nlohmann::json;

/// Reads the tree of one noise.
class LayersReader {
public:
  LayersReader(std::size_t own, std::span<const std::optional<std::size_t>> places,
               FindingList& findings)
      : own_(own), places_(places), findings_(findings) {}

  /// Reads a node and all below it, and returns its index in the result.
  std::size_t readNode(ObjectReader reader) {
    const std::size_t place = layers_.nodes.size();
    layers_.nodes.emplace_back();
    LayerNode node;
    if (const auto index = readNoise(reader, "index"))
      node.index = *index;
    node.proportion = reader.number("proportion", kProportionRange).value_or(node.proportion);
    node.softness = reader.numberOr("softness", kSoftnessRange, node.softness);
    node.below = readSide(reader, "below");
    node.above = readSide(reader, "above");
    reader.warnOfUnknown();
    layers_.nodes[place] = node;
    return place;
  }

  [[nodiscard]] NoiseLayers finish(ObjectReader& noise) && {
    if (!foundOwn_)
      noise.error("layer-self", "layers", "does not name this noise, which is its first layer");
    return std::move(layers_);
  }
  /// Whether a noise that the tree names is one that this version ignores.
  [[nodiscard]] bool namesIgnored() const { return namesIgnored_; }

private:
  [[nodiscard]] std::optional<std::size_t> readNoise(ObjectReader& reader, const char* key) {
    const auto index = reader.integer(key, places_.size() - 1, "noise-index");
    if (!index)
      return std::nullopt;
    namesIgnored_ = namesIgnored_ || !places_[std::size_t(*index)];
    return places_[std::size_t(*index)].value_or(own_);
  }

  LayerSide readSide(ObjectReader& reader, const char* key) {
    const json* side = reader.required(key);
    if (side == nullptr)
      return {};
    if (side->is_object()) {
      if (layers_.nodes.size() < LICHEN_MAX_LAYER_NODES)
        return {true, readNode(ObjectReader(*side, reader.pointerTo(key), findings_))};
      reader.error("layer-count", key,
                   "another node; expected at most " + std::to_string(LICHEN_MAX_LAYER_NODES) +
                       ", for " + std::to_string(LICHEN_MAX_LAYERS) + " layers");
      return {};
    }
    const std::optional<std::size_t> noise = readNoise(reader, key);
    if (!noise || namesIgnored_)
      return {};
    if (*noise == own_ ? foundOwn_ : std::ranges::count(layers_.others, *noise) > 0)
      reader.error("layer-duplicate", key, "the noise is another layer already");
    if (*noise == own_) {
      foundOwn_ = true;
      return {false, 0};
    }
    layers_.others.push_back(*noise);
    return {false, layers_.others.size()};
  }

  std::size_t own_;
  std::span<const std::optional<std::size_t>> places_;
  FindingList& findings_;
  NoiseLayers layers_;
  bool foundOwn_ = false;
  bool namesIgnored_ = false;
};

} // namespace

std::optional<NoiseLayers> readLayers(ObjectReader& noise, std::size_t own,
                                      std::span<const std::optional<std::size_t>> places,
                                      FindingList& findings) {
  const json* member = noise.optional("layers");
  if (member == nullptr)
    return std::nullopt;
  LayersReader reader(own, places, findings);
  reader.readNode(ObjectReader(*member, noise.pointerTo("layers"), findings));
  if (reader.namesIgnored()) {
    findings.warn("layer-ignored", noise.pointerTo("layers"),
                  "a noise among the layers is ignored, and so the first layer is shown alone");
    return std::nullopt;
  }
  return std::move(reader).finish(noise);
}

} // namespace lichen
