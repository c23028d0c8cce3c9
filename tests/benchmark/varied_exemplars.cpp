// SPDX-License-Identifier: MIT
// Number and kind -> parameters -> a picture.
#include "varied_exemplars.h"

#include <lichen/lattice.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lichen::bench {
namespace {

using std::numbers::pi;

/// In [0, 1), from integers.
double random(int x, int y, int seed) {
  return double(pcg3d({std::uint32_t(x), std::uint32_t(y), std::uint32_t(seed)})[0]) * 0x1p-32;
}

/// Smooth noise of one octave, in [0, 1], with cells of length 1.
double valueNoise(double x, double y, int seed) {
  const double i = std::floor(x), j = std::floor(y);
  const auto smooth = [](double t) { return t * t * (3.0 - 2.0 * t); };
  const double u = smooth(x - i), v = smooth(y - j);
  const auto at = [&](int di, int dj) { return random(int(i) + di, int(j) + dj, seed); };
  return (at(0, 0) * (1.0 - u) + at(1, 0) * u) * (1.0 - v) +
         (at(0, 1) * (1.0 - u) + at(1, 1) * u) * v;
}

/// Octaves from `cell` pixels down, each weaker by `gain`.
double octaves(double x, double y, double cell, double gain, int seed) {
  double sum = 0.0, weight = 1.0, weights = 0.0;
  for (int k = 0; k < 5; ++k, weight *= gain, cell *= 0.5) {
    sum += weight * valueNoise(x / cell, y / cell, seed + k);
    weights += weight;
  }
  return sum / weights;
}

/// The nearest and the second nearest of the random points in cells of length 1, and the nearest
/// one's own number in [0, 1).
struct Cell {
  double nearest = 8.0, second = 8.0, own = 0.0;
};
Cell cellAt(double x, double y, int seed) {
  Cell cell;
  const int i = int(std::floor(x)), j = int(std::floor(y));
  for (int dj = -1; dj <= 1; ++dj)
    for (int di = -1; di <= 1; ++di) {
      const double px = i + di + random(i + di, j + dj, seed),
                   py = j + dj + random(i + di, j + dj, seed + 1);
      const double distance = std::hypot(x - px, y - py);
      if (distance < cell.nearest) {
        cell.second = cell.nearest;
        cell.nearest = distance;
        cell.own = random(i + di, j + dj, seed + 2);
      } else {
        cell.second = std::min(cell.second, distance);
      }
    }
  return cell;
}

/// Rows of bricks whose sizes vary by `disorder`: in [0, 1], joints 0.
double bricks(double x, double y, double width, double height, double disorder, int seed) {
  const double row = std::floor(y / height);
  const double across =
      x / width + 0.5 * std::fmod(std::abs(row), 2.0) + disorder * random(int(row), 0, seed);
  const double column = std::floor(across);
  const double toJoint = std::min({(across - column) * width, (column + 1.0 - across) * width,
                                   y - row * height, (row + 1.0) * height - y});
  const double tone = 0.5 + 0.5 * random(int(column), int(row), seed + 1);
  return toJoint < 1.5 ? 0.0 : tone;
}

using Kind = double (*)(double x, double y, double strength, int seed);

constexpr double kPixels = 256.0; // that sizes below are given for

struct NamedKind {
  const char* name;
  Kind valueAt;
};
const std::array<NamedKind, 10> kKinds{
    {{"field",
      [](double x, double y, double s, int seed) { return octaves(x, y, 8 + 24 * s, 0.7, seed); }},
     {"grain", [](double x, double y, double s,
                  int seed) { return octaves(x * (3 + 5 * s), y * 0.4, 24, 0.8, seed); }},
     {"cells", [](double x, double y, double s,
                  int seed) { return cellAt(x / (6 + 14 * s), y / (6 + 14 * s), seed).own; }},
     {"bricks", [](double x, double y, double s,
                   int seed) { return bricks(x, y, 32 + 16 * s, 12 + 6 * s, 0.0, seed); }},
     {"rubble",
      [](double x, double y, double s, int seed) { return bricks(x, y, 28, 14, s, seed); }},
     {"weave",
      [](double x, double y, double s, int seed) {
        const double cell = 6 + 6 * s, over = std::sin(pi * x / cell) * std::sin(pi * y / cell);
        return 0.5 + 0.3 * over + 0.2 * octaves(x, y, 6, 0.7, seed);
      }},
     {"spots",
      [](double x, double y, double s, int seed) {
        const double cell = 10 + 10 * s;
        return cellAt(x / cell, y / cell, seed).nearest < 0.3
                   ? 0.9
                   : 0.2 + 0.2 * octaves(x, y, 8, 0.7, seed + 9);
      }},
     {"blotches",
      [](double x, double y, double s, int seed) {
        return octaves(x, y, 16 + 24 * s, 0.5, seed) > 0.5 ? 0.8 : 0.25;
      }},
     {"veins",
      [](double x, double y, double s, int seed) {
        const double warp = octaves(x, y, 40, 0.5, seed);
        return std::pow(std::abs(std::sin((x + 60 * warp) / (6 + 8 * s))), 0.4);
      }},
     {"gravel", [](double x, double y, double s, int seed) {
        const Cell cell = cellAt(x / (8 + 10 * s), y / (8 + 10 * s), seed);
        return std::min(1.0, 2.0 * (cell.second - cell.nearest)) * (0.5 + 0.5 * cell.own);
      }}}};

} // namespace

std::vector<VariedExemplar> variedExemplars(int sidePixels) {
  constexpr int kOfEach = 6;
  std::vector<VariedExemplar> all;
  for (const NamedKind& kind : kKinds)
    for (int number = 0; number < kOfEach; ++number) {
      VariedExemplar exemplar;
      exemplar.name = std::string(kind.name) + " " + std::to_string(number);
      exemplar.isHeldBack = number % 2 == 1;
      exemplar.image = SrgbImage(sidePixels, sidePixels, 3);
      const double strength = double(number) / (kOfEach - 1);
      const int seed = 100 * number + int(&kind - kKinds.data()) * 1000;
      const double scale = std::sqrt(kPixels / sidePixels);
      for (int y = 0; y < sidePixels; ++y)
        for (int x = 0; x < sidePixels; ++x) {
          const double value = kind.valueAt(scale * x, scale * y, strength, seed);
          const double fine = 0.06 * (random(x, y, seed + 50) - 0.5); // of a camera
          for (std::size_t c = 0; c < 3; ++c) {
            const double low = 0.1 + 0.3 * random(int(c), number, 7),
                         high = 0.5 + 0.4 * random(int(c), number, 8);
            exemplar.image
                .values[(std::size_t(y) * std::size_t(sidePixels) + std::size_t(x)) * 3 + c] =
                float(std::clamp(low + (high - low) * value + fine, 0.0, 1.0));
          }
        }
      all.push_back(std::move(exemplar));
    }
  return all;
}

} // namespace lichen::bench
