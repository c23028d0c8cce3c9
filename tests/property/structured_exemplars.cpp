// SPDX-License-Identifier: MIT
// Generated pictures with a structure are what they claim: their cells, their periods, and where
// whole ones repeat.
#include "agreement.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <structured.h>
#include <structured_sheet.h>
#include <vector>

using namespace lichen;
using namespace lichen::exemplars;
using lichen::test::cellAgreement;
using lichen::test::correlationOf;

namespace {

StructuredPicture pictureOf(const StructuredMaterial& material,
                            const StructuredCondition& condition, int side, std::uint32_t seed) {
  return structured(side, {material.name, condition, seed});
}

constexpr int kWholeSide = 128;

/// A picture that tiles of each material, made once for all cases.
const StructuredPicture& wholePicture(const StructuredMaterial& material) {
  static std::map<const StructuredMaterial*, StructuredPicture> made;
  const auto [place, isNew] = made.try_emplace(&material);
  if (isNew)
    place->second = pictureOf(material, {.name = "whole", .whole = true}, kWholeSide, 3);
  return place->second;
}

/// Turned and sheared, but neither irregular nor noisy: after a period, only raggedness and colours
/// differ.
StructuredPicture slantedPicture(const StructuredMaterial& material, int side) {
  return pictureOf(material,
                   {.name = "slanted",
                    .turnDegrees = -10.0f,
                    .shear = 0.08f,
                    .irregularity = 0.0f,
                    .noise = 0.0f},
                   side, 3);
}

Point halfOf(const Point& offset) { return {0.5f * offset.x, 0.5f * offset.y}; }

/// How many cells lie in the parallelogram of the periods.
int cellsPerPeriod(const StructuredMaterial& material) {
  static const std::map<std::string, int> counts{
      {"bond", 1},  {"english", 3},     {"flemish", 2},  {"tiles", 1},
      {"floor", 1}, {"herringbone", 2}, {"shingles", 1}, {"basket", 4}};
  return counts.at(material.name);
}

bool repeats(const StructuredMaterial& material) { return material.periods[0].x != 0.0f; }

} // namespace

TEST_CASE("structured materials have their own names, and plans have all of them in order") {
  const std::vector<StructuredPlan> plans = structuredPlans();
  std::set<std::string> names;
  for (const StructuredPlan& plan : plans)
    names.insert(plan.name());
  CHECK(names.size() == plans.size());
  CHECK(plans.size() % kStructuredMaterials.size() == 0);
  const std::size_t conditions = plans.size() / kStructuredMaterials.size();
  for (std::size_t i = 0; i < plans.size(); ++i) {
    CHECK(std::string(plans[i].material) == kStructuredMaterials[i / conditions]->name);
    CHECK(plans[i].seed == i + 1);
  }
}

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

TEST_CASE("a whole structured picture differs across its border as it does inside") {
  for (const StructuredMaterial* const material : kStructuredMaterials) {
    const SrgbImage& image = wholePicture(*material).image;
    const auto greenAt = [&](int x, int y) {
      return double(image.pixel(x % kWholeSide, y % kWholeSide)[1]);
    };
    for (const bool isX : {true, false}) {
      const auto step = [&](int k) { // between k - 1 and k, in all lines
        double sum = 0.0;
        for (int line = 0; line < kWholeSide; ++line)
          sum += isX ? std::abs(greenAt(k, line) - greenAt(k - 1, line))
                     : std::abs(greenAt(line, k) - greenAt(line, k - 1));
        return sum;
      };
      INFO(material->name << (isX ? " across x" : " across y"));
      // Outlines along the axis make larger steps inside, but with this seed none is at the border.
      constexpr double kMost = 2.2;
      CHECK(step(kWholeSide) < kMost * 0.5 * (step(kWholeSide - 1) + step(kWholeSide + 1)));
    }
  }
}

TEST_CASE("whole numbers of periods fit into a whole structured picture along each axis") {
  for (const StructuredMaterial* const material : kStructuredMaterials) {
    if (!repeats(*material))
      continue;
    const auto& [first, second] = wholePicture(*material).periods;
    const double area = double(first.x) * second.y - double(first.y) * second.x;
    // Cramer's rule: how many of each lead from one corner to the next.
    for (const double periods : {kWholeSide * second.y / area, -kWholeSide * first.y / area,
                                 -kWholeSide * second.x / area, kWholeSide * first.x / area}) {
      INFO(material->name << ": " << periods);
      CHECK(std::abs(periods - std::round(periods)) < 1e-3);
    }
  }
}

TEST_CASE("a whole structured picture has as many cells as its periods say") {
  for (const StructuredMaterial* const material : kStructuredMaterials) {
    if (!material->hasCells)
      continue;
    const StructuredPicture& picture = wholePicture(*material);
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
    if (!repeats(*material))
      continue;
    const auto& [first, second] = picture.periods;
    const double area = std::abs(double(first.x) * second.y - double(first.y) * second.x);
    CHECK(count == Approx(cellsPerPeriod(*material) * kWholeSide * kWholeSide / area));
  }
}

TEST_CASE("joints of structured pictures lie where their cells say") {
  for (const StructuredMaterial* const material : kStructuredMaterials) {
    if (!material->hasCells || material == &kTiles) // some glaze is as bright as grout
      continue;
    const StructuredPicture& picture = wholePicture(*material);
    SrgbImage joints(kWholeSide, kWholeSide, 3);
    for (std::size_t i = 0; i < picture.cells.size(); ++i)
      joints.values[3 * i + 1] = picture.cells[i] < 0 ? 1.0f : 0.0f;
    const auto likeness = [&](float x, float y) {
      return std::abs(correlationOf(joints, picture.image, {x, y}));
    };
    INFO(material->name);
    CHECK(likeness(0.0f, 0.0f) > 0.15);
    constexpr float kOff = 6.0f; // pixels; farther than shadows
    for (const float x : {-kOff, 0.0f, kOff})
      for (const float y : {-kOff, 0.0f, kOff})
        CHECK(likeness(x, y) <= likeness(0.0f, 0.0f));
  }
}

TEST_CASE("pictures of cells have a colour for each cell and black joints") {
  const std::vector<int> cells{-1, 0, 0, 1};
  const SrgbImage image = coloredCells(2, cells);
  const auto sameColor = [&](std::size_t i, std::size_t j) {
    return std::equal(&image.values[3 * i], &image.values[3 * i] + 3, &image.values[3 * j]);
  };
  CHECK(image.values[0] + image.values[1] + image.values[2] == 0.0f);
  CHECK_FALSE(sameColor(0, 1));
  CHECK(sameColor(1, 2));
  CHECK_FALSE(sameColor(2, 3));
}

TEST_CASE("cells of structured pictures repeat after their periods, and not after half of them") {
  constexpr int kSide = 224;
  for (const StructuredMaterial* const material : kStructuredMaterials) {
    if (!material->hasCells || !repeats(*material))
      continue;
    const StructuredPicture picture = slantedPicture(*material, kSide);
    for (const Point& period : picture.periods) {
      const auto whole = cellAgreement(picture.cells, kSide, period);
      const auto half = cellAgreement(picture.cells, kSide, halfOf(period));
      INFO(material->name << ", (" << period.x << ", " << period.y << ")");
      CHECK(whole.cells > 0.97);
      CHECK(half.cells < 0.85);
      CHECK(whole.joints > 0.6);
    }
  }
}

TEST_CASE("structured pictures without cells repeat after their periods, and less after half") {
  constexpr int kSide = 224;
  for (const StructuredMaterial* const material : kStructuredMaterials) {
    if (material->hasCells)
      continue;
    const StructuredPicture picture = slantedPicture(*material, kSide);
    CHECK(picture.cells.empty());
    for (const Point& period : picture.periods) {
      const double whole = correlationOf(picture.image, picture.image, period);
      const double half = correlationOf(picture.image, picture.image, halfOf(period));
      INFO(material->name << ", (" << period.x << ", " << period.y << ")");
      CHECK(whole > 0.6);
      CHECK(half < whole - 0.2);
    }
  }
}

TEST_CASE("structured pictures of one seed are the same, those of others differ") {
  constexpr int kSide = 48;
  for (const StructuredMaterial* const material : kStructuredMaterials) {
    const StructuredPicture one = pictureOf(*material, {}, kSide, 8);
    const StructuredPicture again = pictureOf(*material, {}, kSide, 8);
    const StructuredPicture other = pictureOf(*material, {}, kSide, 9);
    INFO(material->name);
    CHECK(one.image.values == again.image.values);
    CHECK(one.cells == again.cells);
    // Other stones, and not only other noise of the camera.
    CHECK(std::abs(correlationOf(one.image, other.image)) < 0.5);
    CHECK((one.cells.empty() || one.cells != other.cells));
  }
}

TEST_CASE("maps of a structured material have the colours of its photograph, and fit together") {
  constexpr int kSide = 96;
  const StructuredPlan plan{"cobbles", {.name = "whole", .whole = true}, 3};
  const StructuredPicture picture = structured(kSide, plan);
  const StructuredMaps maps = structuredMaps(kSide, plan);
  CHECK(correlationOf(maps.color, picture.image) > 0.6);
  // Normals lean away from what is higher: to the right, and downwards.
  double across = 0.0, down = 0.0, acrossSquared = 0.0, downSquared = 0.0;
  const auto heightAt = [&](int x, int y) { return maps.height.pixel(x % kSide, y % kSide)[0]; };
  for (int y = 1; y < kSide; ++y)
    for (int x = 1; x < kSide; ++x) {
      const float* normal = maps.normal.pixel(x, y);
      const float slopeX = heightAt(x + 1, y) - heightAt(x - 1, y);
      const float slopeY = heightAt(x, y + 1) - heightAt(x, y - 1);
      across += double(slopeX) * double(normal[0] - 0.5f);
      down += double(slopeY) * double(normal[1] - 0.5f);
      acrossSquared += double(slopeX) * double(slopeX);
      downSquared += double(slopeY) * double(slopeY);
    }
  CHECK(across < -0.5 * acrossSquared);
  CHECK(down > 0.5 * downSquared);
  // Joints are lower, and see less of the sky, than stones.
  double heights[2]{}, skies[2]{}, counts[2]{};
  for (std::size_t i = 0; i < picture.cells.size(); ++i) {
    const bool stone = picture.cells[i] >= 0;
    heights[stone] += double(maps.height.values[i]);
    skies[stone] += double(maps.occlusion.values[i]);
    counts[stone] += 1.0;
  }
  CHECK(heights[0] / counts[0] < heights[1] / counts[1] - 0.2);
  CHECK(skies[0] / counts[0] < skies[1] / counts[1] - 0.05);
}
