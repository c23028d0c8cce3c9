// SPDX-License-Identifier: MIT
// Map, corners -> the part between them as a rectangle.
#include "value_encoding.h"

#include <lichen/regularity.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace lichen {
namespace {

/// The unit square -> a convex quadrilateral, as a plane seen in perspective. [H89] section 2.2.
class Projection {
public:
  explicit Projection(const TileCorners& to) {
    const auto& [a, b, c, d] = to; // of (0, 0), (1, 0), (1, 1), (0, 1)
    const double rightX = b[0] - c[0], rightY = b[1] - c[1];
    const double downX = d[0] - c[0], downY = d[1] - c[1];
    const double sumX = a[0] - b[0] + c[0] - d[0], sumY = a[1] - b[1] + c[1] - d[1];
    const double area = rightX * downY - downX * rightY;
    g_ = (sumX * downY - downX * sumY) / area;
    h_ = (rightX * sumY - sumX * rightY) / area;
    for (std::size_t axis = 0; axis < 2; ++axis)
      rows_[axis] = {b[axis] - a[axis] + g_ * b[axis], d[axis] - a[axis] + h_ * d[axis], a[axis]};
  }

  [[nodiscard]] std::array<double, 2> operator()(double u, double v) const {
    const double scale = 1.0 / (g_ * u + h_ * v + 1.0);
    return {(rows_[0][0] * u + rows_[0][1] * v + rows_[0][2]) * scale,
            (rows_[1][0] * u + rows_[1][1] * v + rows_[1][2]) * scale};
  }

private:
  std::array<std::array<double, 3>, 2> rows_{};
  double g_ = 0.0, h_ = 0.0;
};

/// Weights of the pixels -1, 0, 1 and 2 for a position in [0, 1) between 0 and 1. [K81] eq. 15:
/// of the third order, and sharper than the cubic B-spline.
std::array<float, 4> cubicWeights(float t) {
  return {0.5f * t * (-1.0f + t * (2.0f - t)), 0.5f * (2.0f + t * t * (3.0f * t - 5.0f)),
          0.5f * t * (1.0f + t * (4.0f - 3.0f * t)), 0.5f * t * t * (t - 1.0f)};
}

/// Decoded values of a map between its pixels, clamped at its borders.
class Sampler {
public:
  explicit Sampler(const MapExemplar& map) : map_(map) {
    for (const float value : map.values)
      values_.push_back(exemplar::decoded(value, map.encoding));
  }

  /// Writes a value for each channel, within the range of the pixels around. `x`, `y`: [pixels]
  void sample(double x, double y, float* result) const {
    const int left = int(std::floor(x - 0.5)), top = int(std::floor(y - 0.5));
    const std::array<float, 4> alongX = cubicWeights(float(x - 0.5 - left));
    const std::array<float, 4> alongY = cubicWeights(float(y - 0.5 - top));
    for (std::size_t c = 0; c < map_.channels.size(); ++c) {
      float sum = 0.0f, least = at(left, top, c), most = least;
      for (int k = 0; k < 4; ++k)
        for (int i = 0; i < 4; ++i) {
          const float value = at(left - 1 + i, top - 1 + k, c);
          sum += alongX[std::size_t(i)] * alongY[std::size_t(k)] * value;
          if (i == 1 || i == 2)
            if (k == 1 || k == 2) {
              least = std::min(least, value);
              most = std::max(most, value);
            }
        }
      result[c] = std::clamp(sum, least, most);
    }
  }

private:
  [[nodiscard]] float at(int x, int y, std::size_t c) const {
    const auto column = std::size_t(std::clamp(x, 0, map_.width - 1));
    const auto row = std::size_t(std::clamp(y, 0, map_.height - 1));
    return values_[(row * std::size_t(map_.width) + column) * map_.channels.size() + c];
  }

  const MapExemplar& map_;
  std::vector<float> values_;
};

/// Turns slopes, whose y is up, as the upper side is turned, whose y is down.
void turnSlopes(MapExemplar& map, const TileCorners& corners) {
  const double x = corners[1][0] - corners[0][0], y = corners[1][1] - corners[0][1];
  const auto cosine = float(x / std::hypot(x, y)), sine = float(y / std::hypot(x, y));
  for (std::size_t i = 0; i < map.values.size(); i += 2) {
    const float slopeX = map.values[i], slopeY = map.values[i + 1];
    map.values[i] = cosine * slopeX - sine * slopeY;
    map.values[i + 1] = sine * slopeX + cosine * slopeY;
  }
}

MapExemplar partBetween(const MapExemplar& map, const TileCorners& corners) {
  const Projection inPicture(corners);
  const Sampler sampler(map);
  const auto [width, height] = meanSides(corners);
  MapExemplar part = map;
  part.width = std::max(1, int(std::lround(width)));
  part.height = std::max(1, int(std::lround(height)));
  const std::size_t channels = map.channels.size();
  part.values.resize(std::size_t(part.width) * std::size_t(part.height) * channels);
  float* pixel = part.values.data();
  for (int y = 0; y < part.height; ++y)
    for (int x = 0; x < part.width; ++x, pixel += channels) {
      const auto [fromX, fromY] = inPicture((x + 0.5) / part.width, (y + 0.5) / part.height);
      sampler.sample(fromX, fromY, pixel);
      for (std::size_t c = 0; c < channels; ++c)
        pixel[c] = exemplar::encoded(pixel[c], map.encoding);
    }
  if (map.encoding == ValueEncoding::slope)
    turnSlopes(part, corners);
  return part;
}

} // namespace

Result<void> rectify(std::span<MapExemplar> maps, const TileCorners& corners) {
  const auto exhausted = [] { return "rectify: not enough memory for the maps"; };
  return withinMemory(exhausted, [&]() -> Result<void> {
    const double width = maps.front().width, height = maps.front().height;
    for (MapExemplar& map : maps) {
      TileCorners own = corners;
      for (auto& [x, y] : own) {
        x *= map.width / width;
        y *= map.height / height;
      }
      map = partBetween(map, own);
    }
    return {};
  });
}

} // namespace lichen
