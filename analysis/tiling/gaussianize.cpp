// SPDX-License-Identifier: MIT
// Exemplar points (width * height) -> Gaussian points, by optimal transport [HN18] eq. 21.
#include "gaussianize.h"

#include "borders.h"

namespace lichen::tiling {

Gaussianized gaussianize(const MapExemplar& map, const std::vector<Point>& points, int dimensions,
                         bool periodic, Precision precision, const TransportOptions& transport) {
  Gaussianized result;
  result.width = map.width;
  result.height = map.height;
  result.dimensions = dimensions;
  const std::vector<Point> stratified = stratifiedGaussian(points.size(), dimensions, precision);
  const auto matchTo = [&](const std::vector<Point>& sources) {
    const std::vector<std::uint32_t> assignment = assign(sources, stratified, transport);
    std::vector<Point> matched(sources.size());
    for (std::size_t i = 0; i < sources.size(); ++i)
      matched[i] = stratified[assignment[i]];
    return matched;
  };
  result.matched = matchTo(points);
  result.image =
      periodic ? result.matched : matchTo(crossFadeBorders(result.matched, map.width, map.height));
  return result;
}

} // namespace lichen::tiling
