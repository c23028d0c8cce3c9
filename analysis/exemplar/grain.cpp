// SPDX-License-Identifier: MIT
// A map -> the axis along its streaks.
#include "grain.h"

#include "reduced_plane.h"

#include <lichen/measures.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lichen::exemplar {
namespace {

constexpr int kSmallestSide = 64;
constexpr int kMeasuredSide = 256; // pixels, about: finer detail blurs the direction
constexpr double kAnisotropy = 0.5;
constexpr double kLag = 2.0 / 7.0; // of the side: as long as a cell of the lattice
constexpr double kCorrelation = 0.2;

/// The correlation of pixels that lie (dx, dy) apart.
double correlation(const Plane& plane, int dx, int dy) {
  double product = 0.0, first = 0.0, second = 0.0;
  for (int y = std::max(0, -dy); y < plane.height - std::max(0, dy); ++y)
    for (int x = std::max(0, -dx); x < plane.width - std::max(0, dx); ++x) {
      const double a = double(plane.at(x, y)), b = double(plane.at(x + dx, y + dy));
      product += a * b;
      first += a * a;
      second += b * b;
    }
  const double norm = std::sqrt(first * second);
  return norm > 0.0 ? product / norm : 0.0;
}

} // namespace

Grain grainOf(const MapExemplar& map) {
  if (map.encoding == ValueEncoding::slope || std::min(map.width, map.height) < kSmallestSide)
    return Grain::none;
  const Plane plane = reducedPlane(map, kMeasuredSide);
  const GradientDirection direction = gradientDirection(plane.values, plane.width, plane.height);
  if (direction.anisotropy < kAnisotropy)
    return Grain::none;
  const double along = direction.angle + 0.5 * std::numbers::pi;
  const double lag = kLag * std::min(plane.width, plane.height);
  const int dx = int(std::lround(lag * std::cos(along)));
  const int dy = int(std::lround(lag * std::sin(along)));
  if (correlation(plane, dx, dy) < kCorrelation)
    return Grain::none;
  return std::abs(dx) >= std::abs(dy) ? Grain::x : Grain::y;
}

} // namespace lichen::exemplar
