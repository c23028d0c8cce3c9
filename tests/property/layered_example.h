// SPDX-License-Identifier: MIT
// Layered noises of small baked noises.
#pragma once

#include "bundle_of.h"

#include <lichen/bundle_merge.h>
#include <lichen/index_map.h>

#include <vector>

namespace lichen::test {

/// An index map with round patches, some five across a tile of this shape.
inline Bundle examplePatches(int width, int height, bool hasSolids = false, int bits = 8) {
  SpectrumPicture spectrum;
  spectrum.width = spectrum.height = 17;
  for (int y = -8; y <= 8; ++y)
    for (int x = -8; x <= 8; ++x)
      spectrum.amplitudes.push_back(x * x + y * y > 1 && x * x + y * y <= 25 ? 1.0f : 0.0f);
  return bakeIndexMap(spectrum, double(width) / height, hasSolids, bits).value();
}

/// Noise 0 of each bundle, divided from those after it by nodes that lie in a chain; `shares` of
/// the layers but the last, each within what is left.
inline Bundle layeredExample(const std::vector<Bundle>& layers, const Bundle& index,
                             const std::vector<double>& shares, double softness) {
  std::vector<BundledNoise> noises;
  for (const Bundle& layer : layers)
    noises.push_back({&layer, 0});
  std::vector<LayerNode> nodes;
  for (std::size_t n = 0; n < shares.size(); ++n)
    nodes.push_back({0,
                     1.0 - shares[n],
                     softness,
                     {false, n},
                     n + 1 < shares.size() ? LayerSide{true, n + 1} : LayerSide{false, n + 1}});
  const std::vector<BundledNoise> indices(nodes.size(), {&index, 0});
  return layerNoises("layered", noises, indices, nodes).value();
}

} // namespace lichen::test
