// SPDX-License-Identifier: MIT
// Golden pictures. They were rendered on lavapipe, which is deterministic for a given CPU type.
// Other CPU types and devices round differently, so the comparison uses the mean and the 99.9 %
// quantile of the absolute difference of sRGB codes (0 to 255).
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

/// Compares a PNG with tests/golden/render/NAME.png; with LICHEN_REGENERATE_GOLDEN set, copies it
/// there.
inline void checkGoldenPicture(const std::string& name, const std::filesystem::path& drawn) {
  constexpr double kMeanTolerance = 0.5;
  constexpr double kQuantileTolerance = 8.0; // at edges, where coverage may differ
  const std::filesystem::path path = sourcePath("tests/golden/render/" + name + ".png");
  if (std::getenv("LICHEN_REGENERATE_GOLDEN") != nullptr)
    std::filesystem::copy_file(drawn, path, std::filesystem::copy_options::overwrite_existing);
  const auto now = readImage(drawn);
  const auto golden = readImage(path);
  INFO(name);
  REQUIRE(now.ok());
  REQUIRE(golden.ok());
  const auto& a = std::get<SrgbImage>(now.value().pixels);
  const auto& b = std::get<SrgbImage>(golden.value().pixels);
  REQUIRE((a.width == b.width && a.height == b.height && a.channels == b.channels));
  const std::vector<double> sorted = codeDifferences(a, b);
  double sum = 0.0;
  for (const double d : sorted)
    sum += d;
  CHECK(sum / double(sorted.size()) <= kMeanTolerance);
  CHECK(sorted[sorted.size() * 999 / 1000] <= kQuantileTolerance);
}

} // namespace lichen::test
