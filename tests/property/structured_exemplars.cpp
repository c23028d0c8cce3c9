// SPDX-License-Identifier: MIT
// Generated pictures with a structure are what they claim: they tile, and their cells are as many
// as their periods say.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <structured.h>
#include <structured_sheet.h>

using namespace lichen::exemplars;

namespace {

constexpr int kWholeSide = 128;

/// How many cells lie in the parallelogram of the periods.
int cellsPerPeriod(const StructuredMaterial& material) {
  static const std::map<std::string, int> counts{
      {"bond", 1},  {"english", 3},     {"flemish", 2},  {"tiles", 1},
      {"floor", 1}, {"herringbone", 2}, {"shingles", 1}, {"basket", 4}};
  return counts.at(material.name);
}

} // namespace

TEST_CASE("a structured sheet is the same after its extent along each axis") {
  for (const StructuredMaterial* const material : kStructuredMaterials) {
    const Sheet sheet{77, 0.1f, {3.0f * material->box.x, 2.0f * material->box.y}};
    Random random(5);
    constexpr int kPoints = 1500;
    int same = 0;
    for (int k = 0; k < kPoints; ++k) {
      const Point p{random.range(0.0f, sheet.extent.x), random.range(0.0f, sheet.extent.y)};
      const Surface here = material->at(p, sheet);
      const auto isLike = [&](const Surface& there) {
        constexpr float kColor = 0.01f, kHeight = 0.05f; // code values, pixels
        const auto differ = [](float a, float b, float most) { return std::abs(a - b) > most; };
        return here.joint == there.joint && here.column == there.column && here.row == there.row &&
               !differ(here.color.r, there.color.r, kColor) &&
               !differ(here.color.g, there.color.g, kColor) &&
               !differ(here.color.b, there.color.b, kColor) &&
               !differ(here.height, there.height, kHeight) &&
               !differ(here.gloss, there.gloss, kColor);
      };
      same += int(isLike(material->at({p.x + sheet.extent.x, p.y}, sheet)) &&
                  isLike(material->at({p.x, p.y - sheet.extent.y}, sheet)));
    }
    INFO(material->name);
    // Positions are rounded to 2^-14 pixels, and what has a sharp edge flips there.
    CHECK(double(same) / kPoints > 0.99);
  }
}

TEST_CASE("a whole structured picture has as many cells as its periods say") {
  for (const StructuredMaterial* const material : kStructuredMaterials) {
    if (!material->hasCells)
      continue;
    const StructuredPicture picture =
        structured(kWholeSide, {material->name, {.name = "whole", .whole = true}, 3});
    INFO(material->name);
    REQUIRE(picture.cells.size() == picture.image.pixelCount());
    int count = 0;
    bool isByAppearance = true;
    for (const int cell : picture.cells) {
      isByAppearance = isByAppearance && cell >= -1 && cell <= count;
      count = std::max(count, cell + 1);
    }
    CHECK(isByAppearance);
    const double joints =
        double(std::ranges::count(picture.cells, -1)) / double(picture.cells.size());
    CHECK(joints > 0.03);
    CHECK(joints < 0.35);
    if (material->periods[0].x == 0.0f) // cobbles do not repeat
      continue;
    const auto& [first, second] = picture.periods;
    const double area = std::abs(double(first.x) * second.y - double(first.y) * second.x);
    CHECK(count == Approx(cellsPerPeriod(*material) * kWholeSide * kWholeSide / area));
  }
}
