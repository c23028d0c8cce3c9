// SPDX-License-Identifier: MIT
// Labels (height, width) -> a binary tree of labels, and of each split the proportion and spectrum.
#include "color_clusters.h"
#include "index_spectrum.h"
#include "label_means.h"

#include <lichen/layers.h>

#include <algorithm>
#include <bitset>
#include <limits>
#include <memory>
#include <utility>

namespace lichen {
namespace {

using namespace layers;

/// Labels with one mean colour, and the two groups it was merged from.
struct Group {
  std::bitset<kMostLabels> labels;
  LabelMean mean;
  std::shared_ptr<const Group> below, above; ///< none for a label
};
using Groups = std::vector<std::shared_ptr<const Group>>;

std::shared_ptr<const Group> merged(std::shared_ptr<const Group> a,
                                    std::shared_ptr<const Group> b) {
  if (b->mean.color < a->mean.color) // by lightness
    std::swap(a, b);
  Group group{a->labels | b->labels, {}, a, b};
  group.mean.pixels = a->mean.pixels + b->mean.pixels;
  for (std::size_t c = 0; c < group.mean.color.size(); ++c)
    group.mean.color[c] = float(
        (double(a->mean.color[c]) * a->mean.pixels + double(b->mean.color[c]) * b->mean.pixels) /
        group.mean.pixels);
  return std::make_shared<const Group>(std::move(group));
}

/// Merges the two groups of the nearest colours until one is left.
std::shared_ptr<const Group> mergedAll(Groups groups) {
  while (groups.size() > 1) {
    float least = std::numeric_limits<float>::infinity();
    std::pair<std::size_t, std::size_t> nearest{0, 1};
    for (std::size_t a = 0; a < groups.size(); ++a)
      for (std::size_t b = a + 1; b < groups.size(); ++b)
        if (const float distance = squaredDistance(groups[a]->mean.color, groups[b]->mean.color);
            distance < least) {
          least = distance;
          nearest = {a, b};
        }
    groups[nearest.first] = merged(groups[nearest.first], groups[nearest.second]);
    groups.erase(groups.begin() + std::ptrdiff_t(nearest.second));
  }
  return groups[0];
}

/// Appends the split of a group and the splits below it; returns what stands for the group.
LayerSide appendSplits(const LabelImage& labels, const Group& group,
                       std::vector<LayerSplit>& splits) {
  if (!group.below) {
    for (int label = 0; label < labels.count; ++label)
      if (group.labels.test(std::size_t(label)))
        return {false, std::size_t(label)};
  }
  IndexMap map{labels.width, labels.height, {}, {}};
  for (const std::uint8_t label : labels.labels) {
    map.region.push_back(group.labels.test(label) ? 1.0f : 0.0f);
    map.above.push_back(group.above->labels.test(label) ? 1.0f : 0.0f);
  }
  const std::size_t index = splits.size();
  splits.push_back({map.proportion(), indexSpectrum(map), {}, {}});
  const LayerSide below = appendSplits(labels, *group.below, splits);
  const LayerSide above = appendSplits(labels, *group.above, splits);
  splits[index].below = below;
  splits[index].above = above;
  return {true, index};
}

} // namespace

std::vector<LayerSplit> splitLayers(const MapExemplar& map, const LabelImage& labels) {
  Groups groups;
  for (const LabelMean& mean :
       labelMeans(oklabOf(map), resizedLabels(labels, map.width, map.height))) {
    Group group{{}, mean, nullptr, nullptr};
    group.labels.set(groups.size());
    groups.push_back(std::make_shared<const Group>(std::move(group)));
  }
  // Finer detail than of so many pixels needs more kernels than a noise has.
  constexpr int kMostSide = 1024;
  std::vector<LayerSplit> splits;
  appendSplits(
      resizedLabels(labels, std::min(labels.width, kMostSide), std::min(labels.height, kMostSide)),
      *mergedAll(std::move(groups)), splits);
  return splits;
}

} // namespace lichen
