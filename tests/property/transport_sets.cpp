// SPDX-License-Identifier: MIT
#include "transport_sets.h"

#include <array>
#include <cmath>
#include <random>

namespace lichen::test {
namespace {

/// Standard normal as a sum of twelve uniforms (Irwin-Hall), because the standard library's
/// distributions differ between implementations.
float normal(std::mt19937& random) {
  double sum = -6.0;
  for (int k = 0; k < 12; ++k)
    sum += double(random()) * 0x1.0p-32;
  return float(sum);
}

template <class Make>
Points made(std::size_t count, unsigned seed, Make make) {
  std::mt19937 random(seed);
  Points points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    points.push_back(make(random));
  return points;
}

float to8Bits(float value) { return std::round(value * 255.0f) / 255.0f; }

} // namespace

Points gaussianCloud(std::size_t count, unsigned seed) {
  return made(count, seed, [](std::mt19937& random) {
    const auto coordinate = [&] { return 0.5f + normal(random) / 6.0f; };
    const float x = coordinate(), y = coordinate();
    return Point{x, y, coordinate()};
  });
}

Points clusters(std::size_t count, unsigned seed) {
  constexpr std::array<Point, 5> kCentres{{{0.1f, 0.1f, 0.2f},
                                           {0.9f, 0.8f, 0.7f},
                                           {0.5f, 0.1f, 0.1f},
                                           {0.2f, 0.7f, 0.2f},
                                           {0.6f, 0.6f, 0.9f}}};
  return made(count, seed, [&](std::mt19937& random) {
    // Squaring a uniform index favours the first clusters.
    const double u = double(random()) * 0x1.0p-32;
    const Point& centre = kCentres[std::size_t(u * u * double(kCentres.size()))];
    const auto scatter = [&] { return 0.01f * normal(random); };
    const float x = centre.x + scatter(), y = centre.y + scatter();
    return Point{x, y, centre.z + scatter()};
  });
}

Points quantizedColors(std::size_t count, unsigned seed) {
  return made(count, seed, [](std::mt19937& random) {
    const float mode = (random() >> 31u) != 0 ? 0.3f : 0.6f;
    const float grey = mode + 0.01f * normal(random);
    const float x = to8Bits(grey + 0.003f * normal(random));
    const float y = to8Bits(grey);
    return Point{x, y, to8Bits(0.8f * grey + 0.003f * normal(random))};
  });
}

Points coplanar(std::size_t count, unsigned seed) {
  return made(count, seed, [](std::mt19937& random) {
    const float u = normal(random), v = normal(random);
    return Point{0.2f * u, 0.1f * u + 0.3f * v, 0.1f * u - 0.1f * v};
  });
}

Points collinear(std::size_t count, unsigned seed) {
  return made(count, seed, [](std::mt19937& random) {
    const float t = normal(random);
    return Point{0.3f * t + 0.5f, 0.1f * t, 0.2f - 0.2f * t};
  });
}

Points identical(std::size_t count) { return Points(count, Point{0.25f, 0.5f, 0.75f}); }

std::vector<NamedSet> everyKindOfSet(std::size_t count, unsigned seed) {
  return {
      {"a Gaussian cloud", gaussianCloud(count, seed)}, {"clusters", clusters(count, seed)},
      {"8-bit colours", quantizedColors(count, seed)},  {"coplanar points", coplanar(count, seed)},
      {"collinear points", collinear(count, seed)},     {"one point, repeated", identical(count)}};
}

} // namespace lichen::test
