// SPDX-License-Identifier: MIT
// Exemplar points (width * height) -> Gaussian points, by optimal transport [HN18] eq. 21.
#include "gaussianize.h"

#include "borders.h"
#include "transport/lower_bound.h"

namespace lichen::tiling {

using transport::TransportOptions;

namespace {

/// Where a certificate follows: half a second of several.
constexpr double kAssignmentOfProgress = 0.1;

} // namespace

Gaussianized gaussianize(const MapExemplar& map, const std::vector<Point>& points, int dimensions,
                         bool periodic, Precision precision, const TransportOptions& options,
                         double certificateStep) {
  Gaussianized result;
  result.width = map.width;
  result.height = map.height;
  result.dimensions = dimensions;
  const std::vector<Point> stratified = stratifiedGaussian(points.size(), dimensions, precision);
  const auto matchTo = [&](const std::vector<Point>& sources, double begin, double end) {
    TransportOptions part = options;
    const bool certified = certificateStep > 0.0 && dimensions > 1;
    const double middle = certified ? begin + kAssignmentOfProgress * (end - begin) : end;
    part.progress = options.progress.part(begin, middle);
    std::vector<std::uint32_t> assignment = transport::assign(sources, stratified, part);
    if (certified)
      result.bounds.push_back(transport::improveByAuction(
          sources, stratified, assignment, certificateStep, options.progress.part(middle, end)));
    else if (certificateStep > 0.0) // points on a line are sorted
      result.bounds.push_back(transport::boundOfOptimum(sources, stratified, assignment));
    std::vector<Point> matched(sources.size());
    for (std::size_t i = 0; i < sources.size(); ++i)
      matched[i] = stratified[assignment[i]];
    return matched;
  };
  if (periodic) {
    result.image = result.matched = matchTo(points, 0.0, 1.0);
    return result;
  }
  result.matched = matchTo(points, 0.0, 0.5);
  result.image = matchTo(crossFadeBorders(result.matched, map.width, map.height), 0.5, 1.0);
  return result;
}

} // namespace lichen::tiling
