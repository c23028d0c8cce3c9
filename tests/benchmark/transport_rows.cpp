// SPDX-License-Identifier: MIT
// The distance of the bake's transport from the optimum, and its effect on the Gaussianized image.
#include "exemplars.h"
#include "rows.h"

#include <algorithm>
#include <cstddef>
#include <exemplar/color_space.h>
#include <gaussian/gaussian_distribution.h>
#include <lower_bound.h>
#include <transport/assignment.h>

namespace lichen::bench {
namespace {

using namespace transport;

/// The price step of the bound, which ends up about half a step below the optimum.
constexpr double kStep = 1e-4;
/// In the auction's matching all but a few pairs are within a step; these rounds exchange the rest.
/// More rounds gain less than 0.001 %.
constexpr TransportOptions kExchanges{.swapRounds = 4, .exactRounds = 8};

/// Mean squared difference of neighbours relative to the variance, summed over channels, with
/// wraparound.
double speckle(const std::vector<Point>& gaussian, const std::vector<std::uint32_t>& assignment,
               int width, int height) {
  const auto at = [&](int x, int y) -> const Point& {
    return gaussian[assignment[std::size_t(y % height) * std::size_t(width) +
                               std::size_t(x % width)]];
  };
  double sum = 0.0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (const Point& next : {at(x + 1, y), at(x, y + 1)}) {
        const Point& here = at(x, y);
        const Point d{next.x - here.x, next.y - here.y, next.z - here.z};
        sum += double(dot(d, d));
      }
  const double variance = 3.0 * gaussian::kGaussianDeviation * gaussian::kGaussianDeviation;
  return sum / (variance * double(assignment.size()));
}

} // namespace

std::vector<Row> transportRows() {
  std::vector<double> excesses, speckles;
  double worstExcess = 0.0, worstSpeckle = 0.0;
  std::string worst, speckled;
  for (const Exemplar& exemplar : exemplars256()) {
    const MapExemplar map = baseColorMap(exemplar.image);
    const exemplar::ColorSpace space = exemplar::colorSpaceOf(map);
    const std::vector<Point> source = exemplar::transportPoints(map, space);
    const std::vector<Point> target =
        gaussian::stratifiedGaussian(source.size(), space.dimensions(), gaussian::Precision::bits8);
    const std::vector<std::uint32_t> assignment = assign(source, target, {});
    const test::TransportBound bound = test::boundTransportCost(source, target, assignment, kStep);
    const std::vector<std::uint32_t> nearlyExact =
        improveAssignment(source, target, bound.auctioned, kExchanges);
    const double excess = 100.0 * bound.excess();
    const double ratio = speckle(target, assignment, map.width, map.height) /
                         speckle(target, nearlyExact, map.width, map.height);
    excesses.push_back(excess);
    speckles.push_back(ratio);
    if (excess > worstExcess) {
      worstExcess = excess;
      worst = exemplar.name;
    }
    if (ratio > worstSpeckle) {
      worstSpeckle = ratio;
      speckled = exemplar.name;
    }
  }
  const std::string note = std::to_string(excesses.size()) + " exemplars of 256 x 256";
  return {
      {"transport cost over its certified lower bound, median", median(excesses), 0.3, "%", note},
      {"the same, worst", worstExcess, 0.8, "%", worst},
      {"speckle against a nearly exact solution, median", median(speckles), 1.025, "",
       "mean squared gradient over variance; " + note},
      {"the same, worst", worstSpeckle, 1.025, "", speckled}};
}

} // namespace lichen::bench
