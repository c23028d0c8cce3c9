// SPDX-License-Identifier: MIT
// Map (width * height * channels) -> D images of one dimension, D tables, an affine map.
// [HN18] section 4 in a decorrelated space, as for devices without room for a joint table.
#include "separable.h"

#include "exemplar/value_encoding.h"
#include "prefilter.h"
#include "slab_means.h"

#include <algorithm>
#include <cmath>

namespace lichen::tiling {
namespace {

/// The map's decoded values. Its quantum is the root mean square of the decoded stored quantum.
MapExemplar decodedMap(const MapExemplar& map) {
  MapExemplar result = map;
  result.encoding = ValueEncoding::linear;
  const auto half = float(0.5 * map.quantum);
  double squares = 0.0;
  for (float& value : result.values) {
    const double step = double(exemplar::decoded(value + half, map.encoding)) -
                        double(exemplar::decoded(std::max(0.0f, value - half), map.encoding));
    squares += step * step;
    value = exemplar::decoded(value, map.encoding);
  }
  result.quantum = std::sqrt(squares / double(result.values.size()));
  return result;
}

float coordinate(const Point& point, std::size_t axis) {
  return std::array<float, 3>{point.x, point.y, point.z}[axis];
}

/// The exact values along one axis, in the form that fitInverseTable() takes.
std::vector<float> valuesAlong(const MapExemplar& map, const exemplar::ColorSpace& space,
                               Eigen::Index axis) {
  const std::size_t channels = map.channels.size();
  std::vector<float> values(map.values.size() / channels);
  for (std::size_t i = 0; i < values.size(); ++i) {
    double sum = 0.0;
    for (std::size_t c = 0; c < channels; ++c)
      sum += space.basis(axis, Eigen::Index(c)) *
             (double(map.values[i * channels + c]) - space.moments.mean[Eigen::Index(c)]);
    values[i] = float(sum);
  }
  return values;
}

} // namespace

SeparableFit fitSeparable(const MapExemplar& map, bool periodic, gaussian::Precision precision,
                          ProgressPart progress) {
  progress.reach(0.0);
  const MapExemplar light = decodedMap(map);
  const exemplar::ColorSpace space = exemplar::principalSpaceOf(light);
  if (space.dimensions() < 2)
    return {};
  const std::vector<Point> points = exemplar::transportPoints(light, space, 0.0f);
  SeparableFit fit{space.basis.transpose(), space.moments.mean, {}, {}};
  std::vector<Point> along(points.size());
  for (std::size_t axis = 0; axis < std::size_t(space.dimensions()); ++axis) {
    // The steps common to all axes take a third.
    const auto ended = [&](double parts) {
      progress.reach((1.0 + (2.0 * double(axis) + parts) / double(space.dimensions())) / 3.0);
    };
    ended(0.0);
    std::transform(points.begin(), points.end(), along.begin(), [axis](const Point& p) {
      return Point{coordinate(p, axis), 0.0f, 0.0f};
    });
    fit.axes.push_back(gaussianize(light, along, 1, periodic, precision, {}));
    ended(1.0);
    fit.tables.push_back(fitInverseTable(fit.axes.back(), along,
                                         valuesAlong(light, space, Eigen::Index(axis)), 1, {}));
  }
  return fit;
}

Gaussianized combinedImage(const SeparableFit& fit) {
  Gaussianized image = fit.axes.front();
  image.dimensions = fit.dimensions();
  image.matched.clear();
  for (std::size_t i = 0; i < image.image.size(); ++i) {
    std::array<float, 3> g{};
    for (std::size_t axis = 0; axis < fit.axes.size(); ++axis)
      g[axis] = fit.axes[axis].image[i].x;
    image.image[i] = {g[0], g[1], g[2]};
  }
  return image;
}

std::vector<InverseTable> separableSlabs(const SeparableFit& fit, int bits,
                                         const std::vector<exemplar::ChannelMatrix>& lost) {
  const std::vector<double> levels = tableLevels();
  const int side = fit.tables.front().side;
  const auto dimensions = std::size_t(fit.dimensions());
  const auto cells = std::size_t(side);
  std::vector<InverseTable> slabs(
      levels.size(), {1, side, int(dimensions), std::vector<float>(cells * dimensions)});
  for (std::size_t axis = 0; axis < dimensions; ++axis) {
    std::vector<exemplar::ChannelMatrix> losses;
    for (const double level : levels)
      losses.push_back(lossAt(level, lost).block(Eigen::Index(axis), Eigen::Index(axis), 1, 1));
    std::vector<InverseTable> along = prefilteredSlabsFor(fit.tables[axis], losses);
    restoreSlabMeans(along, gaussianTable(fit.axes[axis], bits), lost);
    for (std::size_t k = 0; k < levels.size(); ++k)
      for (std::size_t cell = 0; cell < cells; ++cell)
        slabs[k].values[cell * dimensions + axis] = along[k].values[cell];
  }
  return slabs;
}

} // namespace lichen::tiling
