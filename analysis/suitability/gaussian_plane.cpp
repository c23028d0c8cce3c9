// SPDX-License-Identifier: MIT
// Exemplar values (width * height * channels) -> Gaussianized principal component (width * height).
#include "gaussian_plane.h"

#include "exemplar/color_space.h"
#include "gaussian/cross_fade.h"
#include "gaussian/gaussian_distribution.h"
#include "transport/rank_matching.h"

namespace lichen::suitability {
namespace {

// Progress after each step, if the borders are cross-faded.
constexpr double kProjected = 0.1;
constexpr double kStratified = 0.4;
constexpr double kRanked = 0.6;
constexpr double kFaded = 0.8;

} // namespace

std::optional<GaussianPlane>
gaussianPlane(const MapExemplar& map, gaussian::BorderTreatment borders, ProgressPart progress) {
  progress.reach(0.0);
  const MapExemplar component = exemplar::principalComponent(map);
  progress.reach(kProjected);
  const exemplar::ColorSpace space = exemplar::colorSpaceOf(component);
  if (space.dimensions() == 0)
    return std::nullopt;
  const std::vector<Point> stratified = gaussian::stratifiedGaussian(
      component.values.size(), 1, gaussian::Precision::bits16); // ascending
  progress.reach(kStratified);
  std::vector<Point> image =
      transport::matchedByRank(exemplar::transportPoints(component, space), stratified);
  progress.reach(kRanked);
  if (!borders.fit) {
    image = gaussian::crossFadeBorders(image, map.width, map.height, borders.grain);
    progress.reach(kFaded);
    image = transport::matchedByRank(image, stratified);
  }
  GaussianPlane plane{map.width, map.height, {}};
  plane.values.reserve(image.size());
  for (const Point& point : image)
    plane.values.push_back((point.x - float(gaussian::kGaussianMean)) /
                           float(gaussian::kGaussianDeviation));
  return plane;
}

} // namespace lichen::suitability
