// SPDX-License-Identifier: MIT
// Maps (height, width, channels) and labels (height, width) -> maps of one label's material.
#include "distance_transform.h"
#include "patch_lattice.h"

#include <lichen/layers.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>

namespace lichen {
namespace {

using namespace layers;

/// The values of a channel over the label.
struct ValueRange {
  float mean = 0.0f, least = 0.0f, most = 0.0f;
};

std::vector<ValueRange> rangesOf(const MapExemplar& map, const Purity& purity) {
  const std::size_t channels = map.channels.size();
  std::vector<ValueRange> ranges;
  for (std::size_t c = 0; c < channels; ++c) {
    double sum = 0.0, weights = 0.0;
    ValueRange range{0.0f, std::numeric_limits<float>::infinity(),
                     -std::numeric_limits<float>::infinity()};
    for (std::size_t i = 0; i < purity.values.size(); ++i)
      if (purity.values[i] > 0.0f) {
        const float value = map.values[i * channels + c];
        sum += double(purity.values[i]) * double(value);
        weights += double(purity.values[i]);
        range.least = std::min(range.least, value);
        range.most = std::max(range.most, value);
      }
    range.mean = float(sum / weights);
    ranges.push_back(range);
  }
  return ranges;
}

MapExemplar filled(const MapExemplar& map, const Purity& purity,
                   const std::vector<PatchLattice>& lattices) {
  const std::size_t channels = map.channels.size();
  const std::vector<ValueRange> ranges = rangesOf(map, purity);
  const auto valueAt = [&](int x, int y, std::size_t c) {
    return map.values[(std::size_t(y) * std::size_t(map.width) + std::size_t(x)) * channels + c];
  };
  MapExemplar result = map;
  tbb::parallel_for(0, map.height, [&](int y) {
    for (int x = 0; x < map.width; ++x) {
      const PatchBlend blend = blendAt(lattices, purity, x, y);
      if (blend.own == 1.0f)
        continue;
      // [HN18] eq. 6. The mean has no variance, yet counts as if it had, so that values fade to it.
      float squares = blend.own * blend.own + blend.mean * blend.mean;
      for (int k = 0; k < blend.taps; ++k)
        squares += blend.tap[std::size_t(k)].weight * blend.tap[std::size_t(k)].weight;
      const float norm = std::sqrt(squares);
      for (std::size_t c = 0; c < channels; ++c) {
        const ValueRange& range = ranges[c];
        float sum = blend.own * (valueAt(x, y, c) - range.mean);
        for (int k = 0; k < blend.taps; ++k) {
          const PatchTap& tap = blend.tap[std::size_t(k)];
          sum += tap.weight * (valueAt(tap.x, tap.y, c) - range.mean);
        }
        result.values[(std::size_t(y) * std::size_t(map.width) + std::size_t(x)) * channels + c] =
            std::clamp(range.mean + sum / norm, range.least, range.most);
      }
    }
  });
  return result;
}

} // namespace

std::vector<MapExemplar> exemplarsOfLabel(std::span<const MapExemplar> maps,
                                          const LabelImage& labels, int label) {
  assert(std::count(labels.labels.begin(), labels.labels.end(), label) > 0);
  const std::vector<float> distance = distanceToOthers(labels, label);
  const std::vector<PatchLattice> lattices = patchLattices(labels, distance);
  std::vector<MapExemplar> exemplars;
  for (const MapExemplar& map : maps)
    exemplars.push_back(filled(map, purityOf(labels, distance, map.width, map.height), lattices));
  return exemplars;
}

} // namespace lichen
