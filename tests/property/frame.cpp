// SPDX-License-Identifier: MIT
// A frame around a picture is found, and lines of the material are none.
#include "base_color.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <exemplar/frame.h>
#include <materials.h>
#include <random>
#include <unsuitable.h>

using namespace lichen;
using lichen::exemplar::insideOfFrame;
using lichen::test::baseColor;

namespace {

constexpr int kSide = 128;
constexpr int kSmoothed = 2; // pixels that are cut off beside a frame

struct Widths {
  int left, top, right, bottom;
};

SrgbImage framed(SrgbImage image, const Widths& widths, float value) {
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (x < widths.left || y < widths.top || x >= image.width - widths.right ||
          y >= image.height - widths.bottom)
        std::fill_n(image.pixel(x, y), 3, value);
  return image;
}

} // namespace

TEST_CASE("a frame is found at all borders that have one, with its width") {
  for (const exemplars::Material& material : exemplars::kMaterials) {
    const SrgbImage image = material.generate(kSide);
    for (const float value : {0.0f, 1.0f})
      for (const Widths& widths : {Widths{1, 1, 1, 1}, Widths{3, 2, 5, 9}, Widths{0, 20, 0, 20},
                                   Widths{0, 0, 4, 0}, Widths{30, 0, 0, 0}}) {
        INFO(material.name << ", " << value << ": " << widths.left << ", " << widths.top << ", "
                           << widths.right << ", " << widths.bottom);
        const auto inside = insideOfFrame(baseColor(framed(image, widths, value)));
        REQUIRE(inside);
        const auto cut = [](int width) { return width == 0 ? 0 : width + kSmoothed; };
        CHECK(inside->x == cut(widths.left));
        CHECK(inside->y == cut(widths.top));
        CHECK(inside->width == kSide - cut(widths.left) - cut(widths.right));
        CHECK(inside->height == kSide - cut(widths.top) - cut(widths.bottom));
      }
  }
}

TEST_CASE("a frame is found although it is dark grey, has the noise of a JPEG, and is not square") {
  constexpr float kNoise = 2.0f / 255.0f;
  SrgbImage image(kSide, kSide / 2, 3);
  const SrgbImage square = exemplars::granite(kSide);
  std::copy_n(square.values.begin(), image.values.size(), image.values.begin());
  image = framed(std::move(image), {6, 6, 6, 6}, 0.1f);
  std::minstd_rand random(7);
  std::uniform_real_distribution<float> noise(-kNoise, kNoise);
  for (float& value : image.values)
    value = std::clamp(value + noise(random), 0.0f, 1.0f);
  const auto inside = insideOfFrame(baseColor(image));
  REQUIRE(inside);
  CHECK(inside->x == 8);
  CHECK(inside->y == 8);
  CHECK(inside->width == kSide - 16);
  CHECK(inside->height == kSide / 2 - 16);
}

TEST_CASE("materials, and what they have of lines themselves, are no frames") {
  for (const exemplars::Material& material : exemplars::kMaterials) {
    INFO(material.name);
    CHECK_FALSE(insideOfFrame(baseColor(material.generate(kSide))));
  }
  for (const exemplars::Unsuitable& kind : exemplars::kUnsuitable) {
    INFO(kind.name);
    CHECK_FALSE(insideOfFrame(baseColor(kind.generate(kSide))));
  }
  SrgbImage grey(kSide, kSide, 3);
  std::fill(grey.values.begin(), grey.values.end(), 0.5f);
  CHECK_FALSE(insideOfFrame(baseColor(grey)));
}

TEST_CASE("grout between tiles is no frame, although it runs along the borders") {
  SrgbImage tiles = exemplars::granite(kSide);
  constexpr int kTile = 32, kGrout = 2;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      if (x % kTile < kGrout || y % kTile < kGrout)
        std::fill_n(tiles.pixel(x, y), 3, 0.9f);
  CHECK_FALSE(insideOfFrame(baseColor(tiles)));
}

TEST_CASE("more than a quarter of a side is no frame") {
  CHECK_FALSE(
      insideOfFrame(baseColor(framed(exemplars::rust(kSide), {0, kSide / 4 + 1, 0, 0}, 1.0f))));
}
