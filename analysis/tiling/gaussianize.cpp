// SPDX-License-Identifier: MIT
// Exemplar points (width * height) -> Gaussian points, by optimal transport [HN18] eq. 21.
#include "gaussianize.h"

#include "borders.h"
#include "tie_order.h"
#include "transport/lower_bound.h"

#include <algorithm>
#include <numeric>

namespace lichen::tiling {

using transport::TransportOptions;

namespace {

/// Where a certificate follows: half a second of several.
constexpr double kAssignmentOfProgress = 0.1;

std::vector<float> firstCoordinates(const std::vector<Point>& points) {
  std::vector<float> x(points.size());
  std::transform(points.begin(), points.end(), x.begin(), [](const Point& p) { return p.x; });
  return x;
}

/// The targets in the order that matches them to the sources, which are near them already.
std::vector<Point> rematched(const std::vector<Point>& sources, const std::vector<Point>& targets,
                             int dimensions, const TransportOptions& options) {
  std::vector<Point> matched(sources.size());
  if (dimensions == 1) {
    const std::vector<std::uint32_t> from = ascendingOrder(firstCoordinates(sources));
    const std::vector<std::uint32_t> to = ascendingOrder(firstCoordinates(targets));
    for (std::size_t rank = 0; rank < from.size(); ++rank)
      matched[from[rank]] = targets[to[rank]];
    return matched;
  }
  std::vector<std::uint32_t> asTheyAre(targets.size());
  std::iota(asTheyAre.begin(), asTheyAre.end(), 0u);
  const std::vector<std::uint32_t> assignment =
      transport::improveAssignment(sources, targets, std::move(asTheyAre), options);
  for (std::size_t i = 0; i < sources.size(); ++i)
    matched[i] = targets[assignment[i]];
  return matched;
}

} // namespace

Gaussianized gaussianize(const MapExemplar& map, const std::vector<Point>& points, int dimensions,
                         bool periodic, Precision precision, const TransportOptions& options,
                         const std::optional<CertificateSteps>& certificate) {
  Gaussianized result;
  result.width = map.width;
  result.height = map.height;
  result.dimensions = dimensions;
  const std::vector<Point> stratified = stratifiedGaussian(points.size(), dimensions, precision);
  const auto matchTo = [&](const std::vector<Point>& sources, double CertificateSteps::*step,
                           double begin, double end) {
    TransportOptions part = options;
    const bool certified = certificate && dimensions > 1;
    const double middle = certified ? begin + kAssignmentOfProgress * (end - begin) : end;
    part.progress = options.progress.part(begin, middle);
    std::vector<std::uint32_t> assignment = transport::assign(sources, stratified, part);
    if (certified)
      result.bounds.push_back(transport::improveByAuction(sources, stratified, assignment,
                                                          (*certificate).*step,
                                                          options.progress.part(middle, end)));
    else if (certificate) // points on a line are sorted
      result.bounds.push_back(transport::boundOfOptimum(sources, stratified, assignment));
    std::vector<Point> matched(sources.size());
    for (std::size_t i = 0; i < sources.size(); ++i)
      matched[i] = stratified[assignment[i]];
    return matched;
  };
  if (periodic) {
    result.image = result.matched = matchTo(points, &CertificateSteps::points, 0.0, 1.0);
    return result;
  }
  result.matched = matchTo(points, &CertificateSteps::points, 0.0, 0.5);
  result.image = matchTo(crossFadeBorders(result.matched, map.width, map.height),
                         &CertificateSteps::faded, 0.5, 1.0);
  return result;
}

Gaussianized gaussianizeNear(const Gaussianized& near, const std::vector<Point>& points,
                             bool periodic, const TransportOptions& options) {
  Gaussianized result;
  result.width = near.width;
  result.height = near.height;
  result.dimensions = near.dimensions;
  TransportOptions part = options;
  part.progress = options.progress.part(0.0, periodic ? 1.0 : 0.5);
  result.matched = rematched(points, near.matched, near.dimensions, part);
  if (periodic) {
    result.image = result.matched;
    return result;
  }
  part.progress = options.progress.part(0.5, 1.0);
  result.image = rematched(crossFadeBorders(result.matched, near.width, near.height), near.image,
                           near.dimensions, part);
  return result;
}

} // namespace lichen::tiling
