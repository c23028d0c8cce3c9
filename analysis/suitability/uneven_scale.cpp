// SPDX-License-Identifier: MIT
// Map -> how much the strength of fine detail changes across it.
#include "uneven_scale.h"

#include "exemplar/reduced_plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace lichen::suitability {
namespace {

using exemplar::Plane;

constexpr int kSide = 256, kSmallestSide = 128; // pixels
constexpr int kStrips = 8;
constexpr int kFine = 1, kCoarse = 8; // pixels of kSide per side, or of a smaller picture's own

/// A part of a plane.
struct Part {
  int x, y, width, height;
};

/// Means over squares of `side` pixels, in [1, 2), around every pixel. The squares overlap: if they
/// were side by side, how they fall on the pixels, and so how much detail they leave, would change
/// across the plane.
Plane averaged(const Plane& plane, double side) {
  const auto beside = float(0.5 * (side - 1.0)); // the share of each neighbour's pixel
  const auto line = [&](const Plane& from, int dx, int dy) {
    Plane to = from;
    for (int y = 0; y < from.height; ++y)
      for (int x = 0; x < from.width; ++x) {
        const float before = from.at(std::max(0, x - dx), std::max(0, y - dy));
        const float after =
            from.at(std::min(from.width - 1, x + dx), std::min(from.height - 1, y + dy));
        to.values[std::size_t(y) * std::size_t(from.width) + std::size_t(x)] =
            (from.at(x, y) + beside * (before + after)) / float(side);
      }
    return to;
  };
  return line(line(plane, 1, 0), 0, 1);
}

/// A plane with kSide * scale values on its shorter side, each averaged over `scale` of them; of a
/// smaller picture its own pixels.
struct ScaledPlane {
  Plane plane;
  double scale = 1.0;
};

ScaledPlane scaledPlane(const MapExemplar& map) {
  Plane plane = exemplar::reducedPlane(map, kSide);
  const double scale = std::max(1.0, double(std::min(plane.width, plane.height)) / kSide);
  return {scale > 1.0 ? averaged(plane, scale) : std::move(plane), scale};
}

/// The mean squared difference of values that lie `lag` apart along either axis.
double wholeDifference(const Plane& plane, const Part& part, int lag) {
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

/// The same for any lag, in proportion between the whole numbers beside it.
double difference(const Plane& plane, const Part& part, double lag) {
  const int below = int(lag);
  const double beyond = lag - below;
  const double atBelow = wholeDifference(plane, part, below);
  return beyond > 0.0 ? atBelow + beyond * (wholeDifference(plane, part, below + 1) - atBelow)
                      : atBelow;
}

/// The octaves of power by which fine detail exceeds coarse detail.
double finenessOf(const ScaledPlane& scaled, const Part& part) {
  constexpr double kRounding = 1.0 / (3.0 * 255.0 * 255.0); // variance of a difference, two axes
  return std::log2((difference(scaled.plane, part, kFine * scaled.scale) + kRounding) /
                   (difference(scaled.plane, part, kCoarse * scaled.scale) + kRounding));
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
  const ScaledPlane scaled = scaledPlane(map);
  const Plane& plane = scaled.plane;
  std::array<double, kStrips> rows{}, columns{};
  for (int k = 0; k < kStrips; ++k) {
    const int top = plane.height * k / kStrips, bottom = plane.height * (k + 1) / kStrips;
    const int left = plane.width * k / kStrips, right = plane.width * (k + 1) / kStrips;
    rows[std::size_t(k)] = finenessOf(scaled, {0, top, plane.width, bottom - top});
    columns[std::size_t(k)] = finenessOf(scaled, {left, 0, right - left, plane.height});
  }
  return std::max(std::abs(trendOf(rows)), std::abs(trendOf(columns)));
}

} // namespace lichen::suitability
