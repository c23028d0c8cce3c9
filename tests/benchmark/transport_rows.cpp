// SPDX-License-Identifier: MIT
// The speckle that the distance of the bake's transport from the optimum leaves in the Gaussianized
// image.
#include "exemplars.h"
#include "rows.h"

#include <cstddef>
#include <exemplar/color_space.h>
#include <gaussian/gaussian_distribution.h>
#include <transport/assignment.h>

namespace lichen::bench {
namespace {

using namespace transport;

constexpr TransportOptions kManyRounds{.swapRounds = 32, .exactRounds = 32};

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
  Measured speckles;
  for (const Exemplar& exemplar : exemplars256()) {
    const MapExemplar map = baseColorMap(exemplar.image);
    const exemplar::ColorSpace space = exemplar::colorSpaceOf(map);
    const std::vector<Point> source = exemplar::transportPoints(map, space);
    const std::vector<Point> target =
        gaussian::stratifiedGaussian(source.size(), space.dimensions(), gaussian::Precision::bits8);
    const std::vector<std::uint32_t> assignment = assign(source, target, {});
    const std::vector<std::uint32_t> better =
        improveAssignment(source, target, assignment, kManyRounds);
    speckles.note(speckle(target, assignment, map.width, map.height) /
                      speckle(target, better, map.width, map.height),
                  exemplar.name);
  }
  std::vector<Row> rows;
  speckles.append(rows, "speckle against a solution of many more rounds", 1.025, "",
                  " of 256 x 256; mean squared gradient over variance");
  return rows;
}

} // namespace lichen::bench
