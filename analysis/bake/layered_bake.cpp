// SPDX-License-Identifier: MIT
// Labels -> exemplars of each label -> noises -> one layered noise.
#include "layered_bake.h"

#include "layers/label_means.h"

#include <lichen/bundle_merge.h>
#include <lichen/index_map.h>
#include <lichen/layered_noise.h>
#include <lichen/layers.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace lichen {
namespace {

/// The map that shows where the materials lie: the base colour, or the first one.
const MapExemplar& guideOf(std::span<const MapExemplar> maps) {
  const auto color = std::ranges::find(maps, MapTarget::baseColor, &MapExemplar::target);
  return color == maps.end() ? maps.front() : *color;
}

Result<LabelImage> labelsOf(const LayersOptions& options, const MapExemplar& guide,
                            SettingWords words, std::vector<std::string>& notes) {
  if (const auto* picture = std::get_if<LabelPicture>(&options)) {
    const auto& [image, name] = *picture;
    constexpr double kTolerance = 0.01;
    const double wide = double(image.width) * guide.height,
                 high = double(image.height) * guide.width;
    if (std::abs(wide - high) > kTolerance * high)
      return Error{
          ErrorKind::badInput,
          fmt::format("{}: {} x {} pixels; expected the shape of the exemplar, which is {} x "
                      "{} after cropping",
                      name, image.width, image.height, guide.width, guide.height)};
    return labelsFromPicture(image, name);
  }
  const int count = std::get<int>(options);
  Result<LabelImage> labels = clusterLabels(guide, count);
  if (!labels)
    return Error{labels.error().kind,
                 words({"layers", std::to_string(count)}) + ": " + labels.error().message};
  constexpr double kSeparate = 0.3;
  if (const double separation = labelSeparation(guide, labels.value()); separation < kSeparate)
    notes.push_back(fmt::format("the {} clusters of colours overlap (separation {:.2f} of 1): look "
                                "at where the layers lie, or give {} a picture of them",
                                count, separation, words({"layers", ""})));
  return labels;
}

/// Whether each map has the centre of a pixel in each label, whatever its size.
Result<void> checkSamples(const LabelImage& labels, std::span<const MapExemplar> maps) {
  for (const MapExemplar& map : maps) {
    std::vector<bool> found(std::size_t(labels.count));
    for (const std::uint8_t label : layers::resizedLabels(labels, map.width, map.height).labels)
      found[label] = true;
    if (std::ranges::count(found, false) > 0)
      return Error{ErrorKind::badInput,
                   fmt::format("the map {} of {} x {} pixels is too small for labels of {} x {}",
                               nameOf(map.target), map.width, map.height, labels.width,
                               labels.height)};
  }
  return {};
}

/// Layer k has label k.
std::vector<LayerNode> nodesOf(std::span<const LayerSplit> splits) {
  std::vector<LayerNode> nodes;
  for (const LayerSplit& split : splits) {
    LayerNode node;
    node.proportion = std::clamp(split.proportion, kProportionRange.least, kProportionRange.most);
    node.below = split.below;
    node.above = split.above;
    nodes.push_back(node);
  }
  return nodes;
}

} // namespace

Result<LayeredBake> bakeLayers(const LayersOptions& options, const std::string& name,
                               std::span<const MapExemplar> maps, const MaterialNoise& material,
                               SettingWords words, const LabelBake& bake) {
  LayeredBake result;
  const MapExemplar& guide = guideOf(maps);
  Result<LabelImage> labels = labelsOf(options, guide, words, result.about.notes);
  if (!labels)
    return labels.error();
  if (Result<void> sampled = checkSamples(labels.value(), maps); !sampled)
    return sampled.error();
  std::vector<Bundle> layers(std::size_t(labels.value().count));
  for (const MapExemplar& map : maps)
    if (const std::string fault = layerTargetFault(layers.size(), map.target); !fault.empty())
      return Error{ErrorKind::usage, fault + "; leave its file out"};
  bool bordersWereKept = true, hasSolids = true;
  for (std::size_t layer = 0; layer < layers.size(); ++layer) {
    Result<MethodBake> baked = bake(exemplarsOfLabel(maps, labels.value(), int(layer)));
    if (!baked)
      return baked.error();
    MethodBake& made = baked.value();
    layers[layer].noises.push_back(std::move(made.noise));
    layers[layer].tables = std::move(made.tables);
    layers[layer].materials.emplace_back(material);
    for (const std::string& line : made.notes)
      result.about.notes.push_back(fmt::format("layer {}: {}", layer + 1, line));
    bordersWereKept = bordersWereKept && made.figures.bordersWereKept;
    hasSolids = hasSolids && mappingObstacle(layers[layer], 0, Mapping::solid).empty();
    if (layer == 0)
      result.about.figures = std::move(made.figures);
  }
  result.about.figures.bordersWereKept = bordersWereKept;
  const std::vector<LayerSplit> splits = splitLayers(guide, labels.value());
  std::vector<Bundle> indices;
  for (const LayerSplit& split : splits) {
    Result<Bundle> baked =
        bakeIndexMap(split.spectrum, double(guide.width) / guide.height, hasSolids);
    if (!baked)
      return baked.error();
    indices.push_back(std::move(baked).value());
    result.proportions.push_back(split.proportion);
  }
  std::vector<BundledNoise> layerNoise, indexNoise;
  for (const Bundle& layer : layers)
    layerNoise.push_back({&layer, 0});
  for (const Bundle& index : indices)
    indexNoise.push_back({&index, 0});
  Result<Bundle> bundle = layerNoises(name, layerNoise, indexNoise, nodesOf(splits));
  if (!bundle)
    return bundle.error();
  result.bundle = std::move(bundle).value();
  return result;
}

} // namespace lichen
