// SPDX-License-Identifier: MIT
// Golden pictures. They were rendered on lavapipe, which is deterministic for a given CPU type.
// Other CPU types and devices round differently, so pixels are compared by the mean and the 99.9 %
// quantile of the absolute difference of sRGB codes (0 to 255), and noises that are fitted by their
// look.
#pragma once

#include "checkout_paths.h"

#include <lichen/image_io.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace lichen::test {

/// Sorted absolute differences in sRGB codes.
inline std::vector<double> codeDifferences(const SrgbImage& a, const SrgbImage& b) {
  std::vector<double> result;
  for (std::size_t i = 0; i < a.values.size(); ++i)
    result.push_back(255.0 * std::abs(double(a.values[i]) - double(b.values[i])));
  std::sort(result.begin(), result.end());
  return result;
}

/// A picture and its golden picture tests/golden/render/NAME.png.
struct GoldenPair {
  SrgbImage drawn;
  SrgbImage golden;
};

/// With LICHEN_REGENERATE_GOLDEN set, copies the PNG to the golden picture first.
inline GoldenPair goldenPair(const std::string& name, const std::filesystem::path& drawn) {
  const std::filesystem::path path = sourcePath("tests/golden/render/" + name + ".png");
  if (std::getenv("LICHEN_REGENERATE_GOLDEN") != nullptr)
    std::filesystem::copy_file(drawn, path, std::filesystem::copy_options::overwrite_existing);
  const auto now = readImage(drawn);
  const auto golden = readImage(path);
  REQUIRE(now.ok());
  REQUIRE(golden.ok());
  GoldenPair pair{std::get<SrgbImage>(now.value().pixels),
                  std::get<SrgbImage>(golden.value().pixels)};
  REQUIRE(pair.drawn.width == pair.golden.width);
  REQUIRE(pair.drawn.height == pair.golden.height);
  REQUIRE(pair.drawn.channels == pair.golden.channels);
  return pair;
}

/// Compares pixel by pixel.
inline void checkGoldenPicture(const std::string& name, const std::filesystem::path& drawn) {
  constexpr double kMeanTolerance = 0.5;
  constexpr double kQuantileTolerance = 8.0; // at edges, where coverage may differ
  INFO(name);
  const auto [now, golden] = goldenPair(name, drawn);
  const std::vector<double> sorted = codeDifferences(now, golden);
  double sum = 0.0;
  for (const double d : sorted)
    sum += d;
  CHECK(sum / double(sorted.size()) <= kMeanTolerance);
  CHECK(sorted[sorted.size() * 999 / 1000] <= kQuantileTolerance);
}

/// The image, averaged over blocks of 16 x 16 pixels.
inline SrgbImage blocksOf(const SrgbImage& image) {
  constexpr int kBlock = 16;
  SrgbImage blocks(image.width / kBlock, image.height / kBlock, image.channels);
  for (int y = 0; y < blocks.height * kBlock; ++y)
    for (int x = 0; x < blocks.width * kBlock; ++x)
      for (int c = 0; c < image.channels; ++c)
        blocks.pixel(x / kBlock, y / kBlock)[c] += image.pixel(x, y)[c] / float(kBlock * kBlock);
  return blocks;
}

/// The sorted values of one channel.
inline SrgbImage sortedChannel(const SrgbImage& image, int channel) {
  SrgbImage sorted(image.width, image.height, 1);
  for (std::size_t i = 0; i < sorted.values.size(); ++i)
    sorted.values[i] = image.values[i * std::size_t(image.channels) + std::size_t(channel)];
  std::ranges::sort(sorted.values);
  return sorted;
}

/// Compares the layout, by means of blocks, and the colours, by the sorted codes of each channel.
/// For noises whose fit turns the last bit of a Fourier transform, which differs between CPU types,
/// into another pattern of the same look. Between a CPU with AVX-512 and one without, the means of
/// blocks differ by up to 3.4 codes and the sorted codes by up to 0.62; between methods, those by
/// 0.8 to 1.9.
inline void checkGoldenLook(const std::string& name, const std::filesystem::path& drawn) {
  constexpr double kBlockTolerance = 5.0, kColorTolerance = 1.0;
  INFO(name);
  const auto [now, golden] = goldenPair(name, drawn);
  const auto mean = [](const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values)
      sum += value;
    return sum / double(values.size());
  };
  CHECK(mean(codeDifferences(blocksOf(now), blocksOf(golden))) <= kBlockTolerance);
  for (int channel = 0; channel < now.channels; ++channel) {
    INFO("channel " << channel);
    CHECK(mean(codeDifferences(sortedChannel(now, channel), sortedChannel(golden, channel))) <=
          kColorTolerance);
  }
}

} // namespace lichen::test
