// SPDX-License-Identifier: MIT
#include "baked_exemplar.h"

#include <lichen/image.h>

#include <algorithm>
#include <cmath>

namespace lichen::test {

using namespace gaussian;

Baked baked(MapExemplar map, bool periodic, gaussian::Precision precision) {
  const exemplar::ColorSpace space = exemplar::colorSpaceOf(map);
  std::vector<Point> points = exemplar::transportPoints(map, space);
  Gaussianized gaussian = gaussianize(map, points, space.dimensions(), {periodic}, precision,
                                      transport::TransportOptions{});
  return {std::move(map), std::move(points), std::move(gaussian)};
}

std::vector<float> tableValues(const MapExemplar& map) {
  std::vector<float> values(map.values.size());
  std::transform(map.values.begin(), map.values.end(), values.begin(),
                 [](float code) { return std::sqrt(srgbToLinear(code)); });
  return values;
}

double slowLookup(const InverseTable& table, const std::array<double, 3>& gaussian, int channel) {
  std::array<std::vector<double>, 3> hats; // hat weights of each axis' cells at the looked-up point
  for (std::size_t axis = 0; axis < std::size_t(table.dimensions); ++axis) {
    const double place =
        std::clamp(table.side * gaussian::gaussianCdf(gaussian[axis]) - 0.5, 0.0, table.side - 1.0);
    for (int cell = 0; cell < table.side; ++cell)
      hats[axis].push_back(std::max(0.0, 1.0 - std::abs(place - cell)));
  }
  double sum = 0.0;
  for (std::size_t cell = 0; cell < table.cellCount(); ++cell) {
    double weight = 1.0;
    std::size_t rest = cell;
    for (std::size_t axis = 0; axis < std::size_t(table.dimensions) && weight > 0.0; ++axis) {
      weight *= hats[axis][rest % std::size_t(table.side)];
      rest /= std::size_t(table.side);
    }
    if (weight > 0.0)
      sum +=
          weight * double(table.values[cell * std::size_t(table.channels) + std::size_t(channel)]);
  }
  return sum;
}

} // namespace lichen::test
