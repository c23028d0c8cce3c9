// SPDX-License-Identifier: MIT
// Exemplar points (width * height) -> Gaussian points, by optimal transport [HN18] eq. 21.
#include "gaussianize.h"

#include "cross_fade.h"
#include "transport/rank_matching.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <numeric>
#include <utility>

namespace lichen::gaussian {

using transport::TransportOptions;

namespace {

/// The target of each source.
std::vector<Point> permuted(const std::vector<Point>& targets,
                            const std::vector<std::uint32_t>& assignment) {
  std::vector<Point> matched(assignment.size());
  std::transform(assignment.begin(), assignment.end(), matched.begin(),
                 [&](std::uint32_t target) { return targets[target]; });
  return matched;
}

/// Reorders the targets to match the sources, which are already close to them.
std::vector<Point> rematched(const std::vector<Point>& sources, const std::vector<Point>& targets,
                             int dimensions, const TransportOptions& options) {
  if (dimensions == 1)
    return transport::matchedByRank(sources, targets);
  std::vector<std::uint32_t> asTheyAre(targets.size());
  std::iota(asTheyAre.begin(), asTheyAre.end(), 0u);
  return permuted(targets,
                  transport::improveAssignment(sources, targets, std::move(asTheyAre), options));
}

/// `near` with other points matched to its pixels and an image made from them.
Gaussianized withImage(const Gaussianized& near, std::vector<Point> matched,
                       gaussian::BorderTreatment borders, const TransportOptions& options) {
  Gaussianized result{near.width, near.height, near.dimensions, {}, std::move(matched)};
  result.image = borders.fit ? result.matched
                             : rematched(gaussian::crossFadeBorders(result.matched, near.width,
                                                                    near.height, borders.grain),
                                         near.image, near.dimensions, options);
  return result;
}

} // namespace

Gaussianized gaussianize(const MapExemplar& map, const std::vector<Point>& points, int dimensions,
                         gaussian::BorderTreatment borders, gaussian::Precision precision,
                         const TransportOptions& options) {
  Gaussianized result{map.width, map.height, dimensions, {}, {}};
  const std::vector<Point> stratified =
      gaussian::stratifiedGaussian(points.size(), dimensions, precision);
  const auto matchTo = [&](const std::vector<Point>& sources, double begin, double end) {
    TransportOptions part = options;
    part.progress = options.progress.part(begin, end);
    return permuted(stratified, transport::assign(sources, stratified, part));
  };
  if (borders.fit) {
    result.image = result.matched = matchTo(points, 0.0, 1.0);
    return result;
  }
  result.matched = matchTo(points, 0.0, 0.5);
  result.image = matchTo(
      gaussian::crossFadeBorders(result.matched, map.width, map.height, borders.grain), 0.5, 1.0);
  return result;
}

Gaussianized gaussianizeNear(const Gaussianized& near, const std::vector<Point>& points,
                             gaussian::BorderTreatment borders, const TransportOptions& options) {
  TransportOptions part = options;
  part.progress = options.progress.part(0.0, borders.fit ? 1.0 : 0.5);
  std::vector<Point> matched = rematched(points, near.matched, near.dimensions, part);
  part.progress = options.progress.part(0.5, 1.0);
  return withImage(near, std::move(matched), borders, part);
}

Gaussianized gaussianizeInOrder(const Gaussianized& near, const std::vector<std::uint32_t>& order,
                                gaussian::BorderTreatment borders) {
  return withImage(near, transport::matchedInOrder(order, near.matched), borders, {});
}

// Map (width * height * n values) -> width * height Gaussian points.

Gaussianized gaussianImage(const MapExemplar& map, gaussian::BorderTreatment borders,
                           gaussian::Precision precision, ProgressPart progress) {
  // Part of the progress; whitening takes the rest.
  constexpr double kPoints = 0.3, kFaded = 0.6;
  const auto n = Eigen::Index(map.channels.size());
  const exemplar::Moments moments = exemplar::momentsOf(map.values, int(n));
  const Eigen::LLT<exemplar::ChannelMatrix> factor(moments.covariance);
  std::vector<Point> points(map.values.size() / std::size_t(n));
  for (std::size_t i = 0; i < points.size(); ++i) {
    exemplar::ChannelVector centred(n);
    for (Eigen::Index c = 0; c < n; ++c)
      centred[c] = double(map.values[i * std::size_t(n) + std::size_t(c)]) - moments.mean[c];
    const exemplar::ChannelVector g =
        gaussian::kGaussianDeviation * factor.matrixL().solve(centred);
    const auto channel = [&](Eigen::Index c) {
      return c < n ? float(gaussian::kGaussianMean + g[c]) : 0.0f;
    };
    points[i] = {channel(0), channel(1), channel(2)};
  }
  progress.reach(kPoints);
  if (!borders.fit)
    points = gaussian::crossFadeBorders(points, map.width, map.height, borders.grain);
  progress.reach(kFaded);
  return {
      map.width, map.height, int(n), gaussian::whitenedForStorage(points, int(n), precision), {}};
}

} // namespace lichen::gaussian
