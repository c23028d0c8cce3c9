// SPDX-License-Identifier: MIT
// A map -> the axis nearest to its streaks.
#include "grain.h"

#include "planes.h"

#include <lichen/measures.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lichen::exemplar {
namespace {

// docs/decisions/006-light-and-grain.md says what these find.
constexpr int kSmallestSide = 64;         // pixels
constexpr int kMeasuredSide = 256;        // pixels, about: finer detail hides the direction
constexpr double kLeastAnisotropy = 0.5;  // three times the energy across the streaks
constexpr double kLagPerSide = 2.0 / 7.0; // about as long as a cell of the lattice
constexpr double kLeastCorrelation = 0.2; // of pixels that far apart

/// The correlation of pixels that lie (dx, dy) apart; 0 if no two pixels do.
double correlationAt(const Plane& plane, int dx, int dy) {
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
  const GradientDirection across = gradientDirection(plane.values, plane.width, plane.height);
  if (across.anisotropy < kLeastAnisotropy)
    return Grain::none;
  const double along = across.angle + 0.5 * std::numbers::pi;
  const bool isNearX = std::abs(std::cos(along)) >= std::abs(std::sin(along));
  // Half of the picture overlaps itself at the least, although it may be long and the streaks
  // steep.
  const double lag = std::min({kLagPerSide * (isNearX ? plane.width : plane.height),
                               0.5 * plane.width / std::max(1e-9, std::abs(std::cos(along))),
                               0.5 * plane.height / std::max(1e-9, std::abs(std::sin(along)))});
  const int dx = int(std::lround(lag * std::cos(along)));
  const int dy = int(std::lround(lag * std::sin(along)));
  if (correlationAt(plane, dx, dy) < kLeastCorrelation)
    return Grain::none;
  return isNearX ? Grain::x : Grain::y;
}

} // namespace lichen::exemplar
