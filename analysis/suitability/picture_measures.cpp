// SPDX-License-Identifier: MIT
// Values (height, width, channels) -> standard deviation of their slowest variation, from eight
// frequencies of the discrete Fourier transform.
#include "picture_measures.h"

#include "exemplar/color_space.h"
#include "exemplar/planes.h"
#include "exemplar/value_encoding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>
#include <vector>

namespace lichen::suitability {
namespace {

constexpr int kSmallestSlowSide = 8; // on a smaller side, one cycle per side is not slow

using Wave = std::vector<std::complex<double>>;

/// exp(-2 pi i (k + 1/2) / side).
Wave oneCycle(int side) {
  Wave wave(static_cast<std::size_t>(side));
  for (int k = 0; k < side; ++k)
    wave[std::size_t(k)] = std::polar(1.0, -2.0 * std::numbers::pi * (k + 0.5) / side);
  return wave;
}

/// Energy of one channel at the eight frequencies, of the transform divided by its size. `across`
/// and `down` are one cycle along each axis.
double slowEnergy(const MapExemplar& map, std::size_t channel, const Wave& across,
                  const Wave& down) {
  // Frequencies (1, 0), (0, 1), (1, 1), (1, -1); the other four are their conjugates.
  std::array<std::complex<double>, 4> sums{};
  const float* value = map.values.data() + channel;
  for (int y = 0; y < map.height; ++y) {
    double level = 0.0;
    std::complex<double> row = 0.0;
    for (int x = 0; x < map.width; ++x, value += map.channels.size()) {
      level += double(*value);
      row += double(*value) * across[std::size_t(x)];
    }
    const std::complex<double> turn = down[std::size_t(y)];
    sums[0] += row;
    sums[1] += level * turn;
    sums[2] += row * turn;
    sums[3] += row * std::conj(turn);
  }
  const double pixels = double(map.width) * double(map.height);
  double energy = 0.0;
  for (const std::complex<double>& sum : sums)
    energy += 2.0 * std::norm(sum / pixels);
  return energy;
}

double spanOf(const MapExemplar& map) {
  switch (map.encoding) {
  case ValueEncoding::srgb:
  case ValueEncoding::root:
  case ValueEncoding::linear:
  case ValueEncoding::index:
    break;
  case ValueEncoding::slope:
    return 2.0;
  case ValueEncoding::log2:
    return std::max(1.0, double(*std::max_element(map.values.begin(), map.values.end())));
  }
  return 1.0;
}

} // namespace

double slowVariation(const MapExemplar& map) {
  if (std::min(map.width, map.height) < kSmallestSlowSide)
    return 0.0;
  const Wave across = oneCycle(map.width), down = oneCycle(map.height);
  double energy = 0.0;
  for (std::size_t c = 0; c < map.channels.size(); ++c)
    energy += slowEnergy(map, c, across, down);
  return std::sqrt(energy / double(map.channels.size()));
}

double slowVariationShare(const MapExemplar& map) { return slowVariation(map) / spanOf(map); }

// Heights (height, width) -> slopes (height, width, 2).
namespace {

/// Standard deviation of a slope component, root mean square over both. The normal maps that come
/// with three height maps have 0.036, 0.23 and 0.27 (docs/decisions/007-verdicts.md). This is
/// the steepest, which shows slow variation best.
constexpr double kReliefDeviation = 0.27;

/// Half the difference between a pixel's two neighbours; the full difference if one of them is the
/// pixel itself.
float difference(float before, float after, bool oneSided) {
  return oneSided ? after - before : 0.5f * (after - before);
}

} // namespace

MapExemplar slopesOfHeight(const MapExemplar& map, bool periodic) {
  MapExemplar slopes;
  slopes.target = MapTarget::normal;
  slopes.channels = {MapChannel::slopeX, MapChannel::slopeY};
  slopes.encoding = ValueEncoding::slope;
  slopes.width = map.width;
  slopes.height = map.height;
  slopes.values.reserve(2 * map.values.size());
  std::vector<float> heights(map.values.size());
  std::transform(map.values.begin(), map.values.end(), heights.begin(),
                 [&](float value) { return exemplar::decoded(value, map.encoding); });
  const auto at = [&](int x, int y) {
    return heights[std::size_t(y) * std::size_t(map.width) + std::size_t(x)];
  };
  const auto neighbour = [periodic](int place, int step, int side) {
    return periodic ? (place + step + side) % side : std::clamp(place + step, 0, side - 1);
  };
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      const int left = neighbour(x, -1, map.width), right = neighbour(x, 1, map.width);
      const int up = neighbour(y, -1, map.height), down = neighbour(y, 1, map.height);
      slopes.values.push_back(difference(at(left, y), at(right, y), left == x || right == x));
      slopes.values.push_back(difference(at(x, down), at(x, up), up == y || down == y));
    }
  const double variance = exemplar::momentsOf(slopes.values, 2).covariance.trace() / 2.0;
  if (variance <= 0.0)
    return slopes;
  const auto scale = float(kReliefDeviation / std::sqrt(variance));
  for (float& slope : slopes.values)
    slope *= scale;
  slopes.quantum = std::min(1.0, map.quantum * double(scale));
  return slopes;
}

// Map -> how much the strength of fine detail changes across it.
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
