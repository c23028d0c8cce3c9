// SPDX-License-Identifier: MIT
// The pictures of quilting_held_back.h are what they claim to be.
#include "quilting_held_back.h"

#include "agreement.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>

using namespace lichen;
using namespace lichen::test;

namespace {

void checkImage(const HeldBackPicture& picture) {
  const SrgbImage& image = picture.image;
  CHECK(image.channels == 3);
  CHECK(image.width == image.height);
  CHECK(image.width >= kSmallestQuiltingSide);
  CHECK(image.width <= kLargestQuiltingSide);
  CHECK(std::ranges::all_of(image.values, [](float v) { return v >= 0.0f && v <= 1.0f; }));
}

/// Each is made once for all cases.
const HeldBackPicture& structuredPicture(int index) {
  static std::map<int, HeldBackPicture> made;
  const auto [place, isNew] = made.try_emplace(index);
  if (isNew)
    place->second = structuredHeldBack(index);
  return place->second;
}

/// Sizes and positions of cells deviate.
bool isIrregular(const HeldBackPicture& picture) {
  return picture.name.ends_with("irregular") || picture.name.ends_with("noisy");
}

} // namespace

TEST_CASE("held-back pictures with a structure have sensible cells", "[large]") {
  for (int index = 0; index < kStructuredHeldBack; ++index) {
    const HeldBackPicture& picture = structuredPicture(index);
    INFO(index << ": " << picture.name);
    checkImage(picture);
    if (picture.cells.empty())
      continue;
    REQUIRE(picture.cells.size() == picture.image.pixelCount());
    const auto joints = double(std::ranges::count(picture.cells, -1));
    CHECK(joints / double(picture.cells.size()) > 0.01);
    CHECK(joints / double(picture.cells.size()) < 0.45);
    const int cells = *std::ranges::max_element(picture.cells) + 1;
    CHECK(cells >= 20);
    CHECK(cells <= 500);
  }
}

TEST_CASE("held-back pictures with a structure repeat after each of their periods, and less after "
          "half of it",
          "[large]") {
  for (int index = 0; index < kStructuredHeldBack; ++index) {
    const HeldBackPicture& picture = structuredPicture(index);
    const int side = picture.image.width;
    const float reach = 0.25f * float(side); // a perspective changes periods farther out
    CHECK(std::hypot(picture.periods[0].x, picture.periods[0].y) > 4.0f);
    for (const exemplars::Point& period : picture.periods) {
      if (period.x == 0.0f && period.y == 0.0f)
        continue; // corduroy has only one
      const exemplars::Point half{0.5f * period.x, 0.5f * period.y};
      INFO(index << ": " << picture.name << ", (" << period.x << ", " << period.y << ")");
      if (picture.cells.empty()) {
        const double whole = correlationOf(picture.image, picture.image, period, reach);
        CHECK(whole > 0.15); // threads are noisy, and periods are not whole pixels
        CHECK(whole > correlationOf(picture.image, picture.image, half, reach) + 0.1);
      } else {
        const double whole = cellAgreement(picture.cells, side, period, reach).cells;
        CHECK(whole > (isIrregular(picture) ? 0.7 : 0.97));
        CHECK(whole > cellAgreement(picture.cells, side, half, reach).cells + 0.05);
      }
    }
  }
}

TEST_CASE("held-back pictures without a structure have neither cells nor periods") {
  for (int index = 0; index < kStochasticHeldBack; index += 11) { // each kind once
    const HeldBackPicture picture = stochasticHeldBack(index);
    INFO(index << ": " << picture.name);
    checkImage(picture);
    CHECK(picture.cells.empty());
    for (const exemplars::Point& period : picture.periods)
      CHECK((period.x == 0.0f && period.y == 0.0f));
  }
}

TEST_CASE("held-back pictures are the same each time") {
  const HeldBackPicture again = structuredHeldBack(25);
  CHECK(structuredPicture(25).image.values == again.image.values);
  CHECK(structuredPicture(25).cells == again.cells);
  CHECK(stochasticHeldBack(4).image.values == stochasticHeldBack(4).image.values);
}
