// SPDX-License-Identifier: MIT
// An exemplar's values (width * height * channels) -> points for the transport.
#include "color_space.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lichen::exemplar {
namespace {

/// Colours on a line or in a plane have exactly the variance of rounding across it, up to sampling.
constexpr double kLeastOverRounding = 2.0;

/// Applies one a-trous pass [1 2 1] / 4 with the given step along one axis, wrapping.
void blur(std::vector<float>& values, std::vector<float>& scratch, int width, int height,
          int channels, int stepX, int stepY) {
  const auto at = [&](int x, int y) {
    return (std::size_t(y) * std::size_t(width) + std::size_t(x)) * std::size_t(channels);
  };
  tbb::parallel_for(0, height, [&](int y) {
    const int above = (y + height - stepY % height) % height;
    const int below = (y + stepY) % height;
    for (int x = 0; x < width; ++x) {
      const int left = (x + width - stepX % width) % width;
      const int right = (x + stepX) % width;
      const float* a = &values[at(left, above)];
      const float* b = &values[at(x, y)];
      const float* c = &values[at(right, below)];
      float* out = &scratch[at(x, y)];
      for (int k = 0; k < channels; ++k)
        out[k] = 0.25f * (a[k] + 2.0f * b[k] + c[k]);
    }
  });
  values.swap(scratch);
}

/// Returns the average over scales s, with weights 4^-s, of the image blurred by 2^s texels, so
/// small scales have the most weight. A side too short for a scale is not blurred along it.
std::vector<float> surroundings(const MapExemplar& map) {
  const int channels = int(map.channels.size());
  std::vector<float> blurred = map.values;
  std::vector<float> scratch(blurred.size());
  std::vector<float> sum(blurred.size(), 0.0f);
  float weight = 0.5f;
  float total = 0.0f;
  // Stop at a quarter of a side. Beyond that, the wrapped kernel averages the whole side.
  for (int step = 1; 4 * step <= std::max(map.width, map.height); step *= 2, weight *= 0.25f) {
    if (4 * step <= map.width)
      blur(blurred, scratch, map.width, map.height, channels, step, 0);
    if (4 * step <= map.height)
      blur(blurred, scratch, map.width, map.height, channels, 0, step);
    for (std::size_t i = 0; i < sum.size(); ++i)
      sum[i] += weight * blurred[i];
    total += weight;
  }
  if (total == 0.0f)
    return map.values;
  for (float& value : sum)
    value /= total;
  return sum;
}

} // namespace

Moments momentsOf(std::span<const float> values, int channels) {
  const auto stride = std::size_t(channels);
  return transport::momentsOf<ChannelMatrix>(
      values.size() / stride, channels,
      [&](std::size_t i, int c) { return values[i * stride + std::size_t(c)]; });
}

ValueRange rangeOf(std::span<const float> values, std::size_t channels, std::size_t channel) {
  ValueRange range{values[channel], values[channel]};
  for (std::size_t i = channel; i < values.size(); i += channels) {
    range.least = std::min(range.least, values[i]);
    range.most = std::max(range.most, values[i]);
  }
  return range;
}

ColorSpace colorSpaceOf(const MapExemplar& map) {
  const int channels = int(map.channels.size());
  ColorSpace space{momentsOf(map.values, channels), {}};
  const auto solver = transport::principalAxes(space.moments.covariance);
  const double roundingVariance = map.quantum * map.quantum / 12.0;
  const double leastVariance = kLeastOverRounding * roundingVariance;
  std::vector<Eigen::Index> kept;
  for (Eigen::Index k = channels; k-- > 0;) // largest first
    if (solver.eigenvalues()[k] > leastVariance)
      kept.push_back(k);
  space.basis.resize(Eigen::Index(kept.size()), channels);
  for (std::size_t row = 0; row < kept.size(); ++row) {
    ChannelVector direction = solver.eigenvectors().col(kept[row]);
    // The sign of an eigenvector is arbitrary; make brighter mean larger.
    if (direction.sum() < 0.0)
      direction = -direction;
    space.basis.row(Eigen::Index(row)) = direction.transpose();
  }
  if (space.dimensions() == channels)
    space.basis = ChannelMatrix::Identity(channels, channels);
  return space;
}

MapExemplar principalComponent(const MapExemplar& map) {
  const std::size_t channels = map.channels.size();
  const Moments moments = momentsOf(map.values, int(channels));
  const auto solver = transport::principalAxes(moments.covariance);
  const ChannelVector axis = solver.eigenvectors().rightCols(1); // ascending eigenvalues
  MapExemplar component;
  component.target = map.target;
  component.channels = {map.channels.front()};
  component.encoding = map.encoding;
  component.width = map.width;
  component.height = map.height;
  component.quantum = map.quantum;
  component.values.reserve(map.values.size() / channels);
  for (std::size_t i = 0; i < map.values.size(); i += channels) {
    double sum = 0.0;
    for (std::size_t c = 0; c < channels; ++c)
      sum += axis[Eigen::Index(c)] * double(map.values[i + c]);
    component.values.push_back(float(sum));
  }
  return component;
}

std::vector<Point> transportPoints(const MapExemplar& map, const ColorSpace& space,
                                   float wantedShare) {
  const int channels = int(map.channels.size());
  const std::vector<float> around = surroundings(map);
  const auto [low, high] = std::minmax_element(map.values.begin(), map.values.end());
  const float range = std::max(*high - *low, std::numeric_limits<float>::min());
  // Half a quantum of the surroundings orders pixels of equal value. On a line the order by value
  // is exact and does not change.
  const float tieBreak = float(0.5 * map.quantum) / range;
  const bool byValue = space.dimensions() == 1 || std::abs(wantedShare) < tieBreak;
  const float share = byValue ? tieBreak : wantedShare;
  std::vector<Point> points(map.values.size() / std::size_t(channels));
  tbb::parallel_for(std::size_t(0), points.size(), [&](std::size_t i) {
    ChannelVector d(channels);
    for (int c = 0; c < channels; ++c) {
      const std::size_t k = i * std::size_t(channels) + std::size_t(c);
      d[c] = double(map.values[k] + share * (around[k] - map.values[k])) - space.moments.mean[c];
    }
    const ChannelVector p = space.basis * d;
    points[i] = {float(p[0]), p.size() > 1 ? float(p[1]) : 0.0f, p.size() > 2 ? float(p[2]) : 0.0f};
  });
  return points;
}

} // namespace lichen::exemplar
