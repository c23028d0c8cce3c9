// SPDX-License-Identifier: MIT
// Blurs white noise, ranks it and assigns colours by rank.
#include "example_exemplar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <transport/random.h>

namespace lichen::test {
namespace {

using transport::randomUniform;

std::vector<double> smoothNoise(int width, int height, std::uint64_t seed, int radius) {
  std::vector<double> noise(std::size_t(width) * std::size_t(height));
  for (std::size_t i = 0; i < noise.size(); ++i)
    noise[i] = randomUniform(seed, i) - 0.5;
  std::vector<double> result(noise.size(), 0.0);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int dy = -radius; dy <= radius; ++dy)
        for (int dx = -radius; dx <= radius; ++dx) {
          const int sx = ((x + dx) % width + width) % width;
          const int sy = ((y + dy) % height + height) % height;
          result[std::size_t(y * width + x)] += noise[std::size_t(sy * width + sx)];
        }
  return result;
}

} // namespace

MapExemplar threeMaterials(int width, int height, std::uint64_t seed, int blurRadius) {
  constexpr std::array<std::array<double, 3>, 3> kColours{
      {{0.75, 0.30, 0.20}, {0.25, 0.45, 0.20}, {0.20, 0.20, 0.35}}};
  const std::vector<double> height0 = smoothNoise(width, height, seed, blurRadius);
  std::vector<std::size_t> order(height0.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return height0[a] < height0[b]; });
  MapExemplar map;
  map.channels = {MapChannel::red, MapChannel::green, MapChannel::blue};
  map.width = width;
  map.height = height;
  map.values.resize(order.size() * 3);
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    const std::size_t i = order[rank];
    // Areas: 1/2, 3/10 and 1/5.
    const double share = double(rank) / double(order.size());
    const std::size_t material = share < 0.5 ? 0 : share < 0.8 ? 1 : 2;
    for (std::size_t c = 0; c < 3; ++c) {
      const double grain = 0.12 * (randomUniform(seed + 1 + c, i) - 0.5);
      map.values[3 * i + c] = float(std::round(255.0 * (kColours[material][c] + grain)) / 255.0);
    }
  }
  return map;
}

MapExemplar cropped(const MapExemplar& map, int x, int y, int width, int height) {
  MapExemplar result = map;
  const std::size_t channels = map.channels.size();
  result.width = width;
  result.height = height;
  result.values.clear();
  for (int row = 0; row < height; ++row) {
    const float* begin =
        &map.values[(std::size_t(y + row) * std::size_t(map.width) + std::size_t(x)) * channels];
    result.values.insert(result.values.end(), begin, begin + std::size_t(width) * channels);
  }
  return result;
}

} // namespace lichen::test
