// SPDX-License-Identifier: MIT
// Map -> how much the strength of fine detail changes across it.
#include "uneven_scale.h"

#include "exemplar/reduced_plane.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lichen::suitability {
namespace {

using exemplar::Plane;

constexpr int kSide = 256, kSmallestSide = 128; // pixels
constexpr int kStrips = 8;
constexpr int kFine = 1, kCoarse = 8; // pixels

/// A part of a plane.
struct Part {
  int x, y, width, height;
};

/// The mean squared difference of values that lie `lag` apart along either axis.
double difference(const Plane& plane, const Part& part, int lag) {
  double along = 0.0, down = 0.0;
  for (int y = part.y; y < part.y + part.height; ++y)
    for (int x = part.x; x + lag < part.x + part.width; ++x)
      along += std::pow(double(plane.at(x, y)) - double(plane.at(x + lag, y)), 2.0);
  for (int y = part.y; y + lag < part.y + part.height; ++y)
    for (int x = part.x; x < part.x + part.width; ++x)
      down += std::pow(double(plane.at(x, y)) - double(plane.at(x, y + lag)), 2.0);
  return along / (double(part.width - lag) * part.height) +
         down / (double(part.width) * (part.height - lag));
}

/// The octaves of power by which fine detail exceeds coarse detail.
double finenessOf(const Plane& plane, const Part& part) {
  constexpr double kRounding = 1.0 / (3.0 * 255.0 * 255.0); // variance of a difference, two axes
  return std::log2((difference(plane, part, kFine) + kRounding) /
                   (difference(plane, part, kCoarse) + kRounding));
}

/// The change from the first value to the last, along the line that fits them best.
double trendOf(const std::array<double, kStrips>& values) {
  double product = 0.0, squares = 0.0;
  for (int k = 0; k < kStrips; ++k) {
    const double place = (k + 0.5) / kStrips - 0.5;
    product += place * values[std::size_t(k)];
    squares += place * place;
  }
  return product / squares;
}

} // namespace

double unevenScale(const MapExemplar& map) {
  if (map.target != MapTarget::baseColor || std::min(map.width, map.height) < kSmallestSide)
    return 0.0;
  const Plane plane = exemplar::reducedPlane(map, kSide);
  std::array<double, kStrips> rows{}, columns{};
  for (int k = 0; k < kStrips; ++k) {
    const int top = plane.height * k / kStrips, bottom = plane.height * (k + 1) / kStrips;
    const int left = plane.width * k / kStrips, right = plane.width * (k + 1) / kStrips;
    rows[std::size_t(k)] = finenessOf(plane, {0, top, plane.width, bottom - top});
    columns[std::size_t(k)] = finenessOf(plane, {left, 0, right - left, plane.height});
  }
  return std::max(std::abs(trendOf(rows)), std::abs(trendOf(columns)));
}

} // namespace lichen::suitability
