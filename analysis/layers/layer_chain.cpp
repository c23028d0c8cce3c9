// SPDX-License-Identifier: MIT
// Shares of the area -> a chain of nodes that divides it among the layers.
#include <lichen/layers.h>

#include <fmt/format.h>

#include <numeric>

namespace lichen {

Result<std::vector<LayerNode>> layerChain(std::span<const double> shares, double softness) {
  std::vector<LayerNode> nodes(shares.size() - 1);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const double rest = std::accumulate(shares.begin() + std::ptrdiff_t(n), shares.end(), 0.0);
    const double proportion = (rest - shares[n]) / rest;
    if (!(proportion >= kProportionRange.least && proportion <= kProportionRange.most))
      return Error{
          ErrorKind::usage,
          fmt::format("a layer has {:g}, and all layers after it have {:g}; expected each of the "
                      "two to be at least a hundredth of their sum",
                      shares[n], rest - shares[n])};
    nodes[n].proportion = proportion;
    nodes[n].softness = softness;
    nodes[n].below = {false, n};
    nodes[n].above = n + 1 < nodes.size() ? LayerSide{true, n + 1} : LayerSide{false, n + 1};
  }
  return nodes;
}

} // namespace lichen
