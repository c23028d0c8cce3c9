// SPDX-License-Identifier: MIT
// The points at which `lichen synth` evaluates a noise: seeds, origins and borders.
#include "command_run.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace lichen;
using namespace lichen::cli_test;

namespace {

constexpr int kExemplarSide = 32;

/// One bundle for all tests of this file; its features are several texels wide.
struct Made {
  Workplace workplace;
  std::string bundle = bake(workplace, workplace.write("smooth.png", smooth(kExemplarSide)));
};

SrgbImage made(const Arguments& more) {
  static const Made made;
  return synth(made.workplace, made.bundle, more);
}

double difference(const float* a, const float* b) {
  return std::abs(double(a[0]) - double(b[0])) + std::abs(double(a[1]) - double(b[1])) +
         std::abs(double(a[2]) - double(b[2]));
}

/// Returns the mean difference between columns `line` and `line` + 1, or rows if `rows`; the first
/// follows the last.
double stepAfter(const SrgbImage& image, int line, bool rows) {
  const int lines = rows ? image.height : image.width;
  const int length = rows ? image.width : image.height;
  const int next = (line + 1) % lines;
  double sum = 0.0;
  for (int i = 0; i < length; ++i)
    sum += rows ? difference(image.pixel(i, line), image.pixel(i, next))
                : difference(image.pixel(line, i), image.pixel(next, i));
  return sum / length;
}

/// Returns the step across the border, relative to the mean step inside.
double seam(const SrgbImage& image, bool rows) {
  const int last = (rows ? image.height : image.width) - 1;
  double inside = 0.0;
  for (int line = 0; line < last; ++line)
    inside += stepAfter(image, line, rows) / last;
  return stepAfter(image, last, rows) / inside;
}

/// Returns the fraction of pixels in which the two images differ by more than one code in some
/// channel.
double shareOfDifferent(const SrgbImage& a, const SrgbImage& b) {
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.pixelCount(); ++i) {
    bool differs = false;
    for (std::size_t c = 0; c < 3; ++c)
      differs = differs || std::abs(a.values[3 * i + c] - b.values[3 * i + c]) > 1.5f / 255.0f;
    different += differs ? 1 : 0;
  }
  return double(different) / double(a.pixelCount());
}

double deviation(const SrgbImage& image) {
  const std::vector<double> mean = meanOf(image);
  double sum = 0.0;
  for (std::size_t i = 0; i < image.values.size(); ++i)
    sum += std::pow(double(image.values[i]) - mean[i % 3], 2.0);
  return std::sqrt(sum / double(image.values.size()));
}

} // namespace

TEST_CASE("opposite borders of a tileable image continue each other") {
  // Whole exemplars, a fraction of one, and unequal sides.
  for (const char* size : {"96x96", "80x112"}) {
    INFO(size);
    const SrgbImage tileable = made({"--size", size, "--tileable"});
    CHECK(seam(tileable, false) < 1.5);
    CHECK(seam(tileable, true) < 1.5);
    const SrgbImage plain = made({"--size", size});
    CHECK(seam(plain, false) > 2.5);
    CHECK(seam(plain, true) > 2.5);
  }
}

TEST_CASE("--origin shifts a tileable image in itself") {
  const int side = 3 * kExemplarSide;
  const SrgbImage still = made({"--size", "96x96", "--tileable"});
  const SrgbImage shifted = made({"--size", "96x96", "--tileable", "--origin", "3000000.5,-1.25"});
  SrgbImage expected(side, side, 3);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      std::copy_n(
          still.pixel((x + kExemplarSide / 2) % side, (y + side - kExemplarSide * 5 / 4) % side), 3,
          expected.pixel(x, y));
  CHECK(shareOfDifferent(shifted, still) > 0.9);
  CHECK(shareOfDifferent(shifted, expected) == 0.0);
  CHECK(seam(shifted, false) < 1.5);
  CHECK(seam(shifted, true) < 1.5);
}

TEST_CASE("the error for a tileable size under half a tile names the limits that help") {
  const Workplace workplace;
  const std::string bundle = bake(workplace, workplace.write("moss.png", smoothGrey(32)));
  const Arguments synthesis{"synth",      bundle,   "-o",   workplace.path("a.png"),
                            "--tileable", "--size", "10x20"};
  checkRefusal(synthesis, kUsage, {"at least 16x16, or at most 20 texels per tile"});
  succeed(synthesis + Arguments{"--texels-per-tile", "20"});
}

TEST_CASE("the material's seed decides the pattern, unless --seed overrides it") {
  const Workplace workplace;
  const std::string bundle =
      bake(workplace, workplace.write("smooth.png", smooth(16)), "noise.glb", {"--seed", "12"});
  const SrgbImage own = synth(workplace, bundle, {"--size", "32x32"});
  CHECK(own.values == synth(workplace, bundle, {"--size", "32x32", "--seed", "12"}).values);
  for (const char* seed : {"1", "4294967295"})
    CHECK(shareOfDifferent(synth(workplace, bundle, {"--size", "32x32", "--seed", seed}), own) >
          0.9);
}

TEST_CASE("each number of --tile-rotation gives another pattern, and none is the default") {
  const Arguments near{"--size", "64x64"};
  const auto with = [](const Arguments& view, const char* option, const char* value) {
    return made(view + Arguments{option, value});
  };
  const SrgbImage none = made(near), two = with(near, "--tile-rotation", "2");
  CHECK((with(near, "--tile-rotation", "none").values == none.values));
  CHECK(shareOfDifferent(two, none) > 0.3);
  CHECK(shareOfDifferent(with(near, "--tile-rotation", "4"), two) > 0.3);
}

TEST_CASE("--texels-per-tile magnifies the same pattern") {
  const SrgbImage plain = made({"--size", "64x64"});
  const SrgbImage large = made({"--size", "128x128", "--texels-per-tile", "64"});
  // Pixel centres of the plain image lie between pixel centres of the large one: the mean of four
  // is close.
  double sum = 0.0;
  for (int y = 0; y < plain.height; ++y)
    for (int x = 0; x < plain.width; ++x)
      for (int c = 0; c < 3; ++c) {
        const float mean =
            0.25f * (large.pixel(2 * x, 2 * y)[c] + large.pixel(2 * x + 1, 2 * y)[c] +
                     large.pixel(2 * x, 2 * y + 1)[c] + large.pixel(2 * x + 1, 2 * y + 1)[c]);
        sum += std::abs(double(mean) - double(plain.pixel(x, y)[c]));
      }
  CHECK(sum / double(plain.values.size()) < 0.1 * deviation(plain));
}
