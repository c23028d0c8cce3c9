// SPDX-License-Identifier: MIT
// Halved images against sums over whole numbers of equal parts of their texels.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exemplar/planes.h>
#include <numeric>
#include <random>
#include <vector>

using namespace lichen;
using lichen::exemplar::areaAverage;
using lichen::exemplar::ImageLevel;

namespace {

constexpr int kAveragedSides[] = {1, 2, 3, 4, 5, 7, 8, 9, 17, 30};

ImageLevel randomLevel(int width, int height, int channels, std::uint32_t seed) {
  ImageLevel level{width, height, channels, {}};
  std::mt19937 generator(seed);
  std::uniform_real_distribution<float> uniform(-1.0f, 2.0f);
  for (int i = 0; i < width * height * channels; ++i)
    level.values.push_back(uniform(generator));
  return level;
}

double meanOf(const ImageLevel& level, int channel) {
  double sum = 0.0;
  for (std::size_t i = std::size_t(channel); i < level.values.size();
       i += std::size_t(level.channels))
    sum += double(level.values[i]);
  return sum * level.channels / double(level.values.size());
}

/// The mean of the source where a destination texel lies: each source texel is cut into as many
/// parts along an axis as there are destination texels, so that both have borders between parts.
double meanOfParts(const ImageLevel& source, int width, int height, int x, int y, int channel) {
  double sum = 0.0;
  for (int j = y * source.height; j < (y + 1) * source.height; ++j)
    for (int i = x * source.width; i < (x + 1) * source.width; ++i)
      sum += double(source.values[std::size_t(
          ((j / height) * source.width + i / width) * source.channels + channel)]);
  return sum / (double(source.width) * source.height);
}

} // namespace

TEST_CASE("a halved image averages the area of each texel, also of odd sides") {
  for (const int width : kAveragedSides)
    for (const int height : kAveragedSides) {
      constexpr int kChannels = 3;
      const ImageLevel source =
          randomLevel(width, height, kChannels, std::uint32_t(100 * width + height));
      const ImageLevel half = areaAverage(source);
      INFO(width << " x " << height);
      REQUIRE(half.width == std::max(1, width / 2));
      REQUIRE(half.height == std::max(1, height / 2));
      REQUIRE(half.channels == kChannels);
      REQUIRE(half.values.size() == std::size_t(half.width * half.height * kChannels));
      double most = 0.0;
      for (int y = 0; y < half.height; ++y)
        for (int x = 0; x < half.width; ++x)
          for (int c = 0; c < kChannels; ++c)
            most = std::max(
                most,
                std::abs(meanOfParts(source, half.width, half.height, x, y, c) -
                         double(half.values[std::size_t((y * half.width + x) * kChannels + c)])));
      CHECK(most < 1e-6); // values of up to 2, rounded to float
    }
}

TEST_CASE("all levels of an image have its mean, down to a single texel") {
  for (const int width : kAveragedSides)
    for (const int height : kAveragedSides) {
      ImageLevel level = randomLevel(width, height, 2, std::uint32_t(width + 100 * height));
      const double first = meanOf(level, 0), second = meanOf(level, 1);
      while (level.width > 1 || level.height > 1) {
        level = areaAverage(level);
        INFO(width << " x " << height << " at " << level.width << " x " << level.height);
        CHECK(std::abs(meanOf(level, 0) - first) < 1e-6);
        CHECK(std::abs(meanOf(level, 1) - second) < 1e-6);
      }
    }
}
