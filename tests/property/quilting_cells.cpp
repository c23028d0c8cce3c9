// SPDX-License-Identifier: MIT
// The cells of pictures that are drawn from cells.
#include "plane_of.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <quilting/cells.h>
#include <random>
#include <vector>

using namespace lichen;
using lichen::quilting::CellField;
using lichen::quilting::CellImage;
using lichen::quilting::cellImage;
using lichen::quilting::cellsOf;

namespace {

constexpr int kWallWidth = 256, kWallHeight = 160;
constexpr int kBrickWidth = 64, kBrickHeight = 40, kMortar = 4; // pixels; pitches
constexpr double kBricks = 16.0;                                // in the wall

/// Where pixels of a wall in running bond lie; its first brick begins at (shiftX, shiftY).
struct Bond {
  int shiftX = 0, shiftY = 0;

  struct Brick {
    int column = 0, row = 0;
    double inside = 0.0;              ///< distance to the middle of the mortar, pixels
    std::array<double, 2> toCentre{}; ///< pixels
  };
  [[nodiscard]] Brick at(double x, double y) const {
    const double down = (y - shiftY) / kBrickHeight;
    const int row = int(std::floor(down));
    const double across = (x - shiftX) / kBrickWidth - 0.5 * (row & 1);
    const int column = int(std::floor(across));
    const double u = across - column, v = down - row;
    const double inX = kBrickWidth * std::min(u, 1.0 - u);
    const double inY = kBrickHeight * std::min(v, 1.0 - v);
    return {(column % 4 + 4) % 4,
            (row % 4 + 4) % 4,
            std::min(inX, inY),
            {kBrickWidth * (0.5 - u), kBrickHeight * (0.5 - v)}};
  }
};

/// Bricks of random tones in dark mortar.
MapExemplar wallOf(const Bond& bond) {
  std::mt19937 generator(4);
  std::uniform_real_distribution<float> uniform(0.4f, 0.9f);
  std::array<std::array<float, 4>, 4> tones{};
  for (auto& row : tones)
    for (float& tone : row)
      tone = uniform(generator);
  return test::planeOf(kWallWidth, kWallHeight, [&](int x, int y) {
    const Bond::Brick brick = bond.at(x + 0.5, y + 0.5);
    return brick.inside < 0.5 * kMortar ? 0.1f
                                        : tones[std::size_t(brick.row)][std::size_t(brick.column)];
  });
}

/// The difference of two positions on a circle of circumference 1, in [-1/2, 1/2].
double around(double difference) { return difference - std::round(difference); }

const CellField& wallCells() {
  static const MapExemplar wall = wallOf({});
  static const CellField cells = cellsOf({&wall, 1}, kBricks);
  return cells;
}

} // namespace

TEST_CASE(
    "texels of a brick point to its centre, texels of mortar to the centre of a brick beside it") {
  for (const Bond& bond : {Bond{}, Bond{30, 14}}) {
    const MapExemplar wall = wallOf(bond);
    const CellField cells = cellsOf({&wall, 1}, kBricks);
    REQUIRE(cells.width == kWallWidth / 2);
    REQUIRE(cells.height == kWallHeight / 2);
    REQUIRE(cells.toCentre.size() == std::size_t(cells.width) * std::size_t(cells.height));
    constexpr double kMost = 1.5; // pixels; texels are 2 apart
    double worst = 0.0, worstOfMortar = 0.0;
    for (int y = 0; y < cells.height; ++y)
      for (int x = 0; x < cells.width; ++x) {
        const auto& toCentre =
            cells.toCentre[std::size_t(y) * std::size_t(cells.width) + std::size_t(x)];
        const double px = (x + 0.5) * kWallWidth / cells.width;
        const double py = (y + 0.5) * kWallHeight / cells.height;
        const auto missOf = [&](const Bond::Brick& brick) {
          return std::hypot(double(toCentre[0]) * kWallWidth - brick.toCentre[0],
                            double(toCentre[1]) * kWallHeight - brick.toCentre[1]);
        };
        const Bond::Brick own = bond.at(px, py);
        if (own.inside > 0.5 * kMortar) {
          worst = std::max(worst, missOf(own));
          continue;
        }
        // A brick that is within the width of the mortar.
        double best = 1e9;
        for (const double dx : {-kMortar, 0, kMortar})
          for (const double dy : {-kMortar, 0, kMortar}) {
            Bond::Brick beside = bond.at(px + dx, py + dy);
            beside.toCentre[0] += dx;
            beside.toCentre[1] += dy;
            best = std::min(best, missOf(beside));
          }
        worstOfMortar = std::max(worstOfMortar, best);
      }
    CHECK(worst < kMost);
    CHECK(worstOfMortar < kMost);
  }
}

TEST_CASE("the cells of a picture that is moved around its borders move along") {
  constexpr int kRight = 74, kDown = 34; // even, since cells are found at half the size
  const MapExemplar moved = wallOf({kRight, kDown});
  const CellField there = cellsOf({&moved, 1}, kBricks);
  const CellField& here = wallCells();
  double most = 0.0;
  for (int y = 0; y < here.height; ++y)
    for (int x = 0; x < here.width; ++x) {
      const auto& a = here.toCentre[std::size_t(y * here.width + x)];
      const auto& b = there.toCentre[std::size_t((y + kDown / 2) % here.height * here.width +
                                                 (x + kRight / 2) % here.width)];
      most = std::max(most, std::hypot(around(double(a[0] - b[0])), around(double(a[1] - b[1]))));
    }
  CHECK(most < 1e-3);
}

TEST_CASE("along stripes the coordinate stays, across them texels point to the middle of theirs") {
  for (const auto& [side, stripe] : {std::pair{160, 20}, {161, 23}})
    for (const bool isAlongX : {true, false}) {
      const MapExemplar stripes = test::planeOf(side, side, [&](int x, int y) {
        return 0.1f * float(3 * ((isAlongX ? y : x) / stripe) % (side / stripe)); // all differ
      });
      const CellField cells = cellsOf({&stripes, 1}, double(side) / stripe);
      double along = 0.0, across = 0.0;
      for (int y = 0; y < cells.height; ++y)
        for (int x = 0; x < cells.width; ++x) {
          const auto& toCentre = cells.toCentre[std::size_t(y * cells.width + x)];
          const double at = (isAlongX ? y + 0.5 : x + 0.5) * side / cells.height;
          const double within = at - stripe * std::floor(at / stripe);
          along = std::max(along, std::abs(double(toCentre[isAlongX ? 0 : 1])));
          if (std::min(within, stripe - within) > 2.0)
            across = std::max(across, std::abs(double(toCentre[isAlongX ? 1 : 0]) * side -
                                               (0.5 * stripe - within)));
        }
      INFO(side << " pixels");
      CHECK(along < 1e-4);
      CHECK(across < (side % 2 == 0 ? 0.5 : 1.0)); // pixels
    }
}

TEST_CASE("a picture without edges has no cells") {
  const MapExemplar constant = test::planeOf(96, 80, [](int, int) { return 0.25f; });
  for (const double count : {1.0, 150.0})
    for (const std::array<float, 2>& toCentre : cellsOf({&constant, 1}, count).toCentre)
      for (const float axis : toCentre) {
        REQUIRE(std::isfinite(axis));
        REQUIRE(std::abs(axis) < 1e-5f);
      }
}

TEST_CASE("cells much larger than usual ones are divided: their texels point less far") {
  const MapExemplar wall = wallOf({});
  double before = 1.0;
  for (const double count : {kBricks, 1e2 * kBricks, 1e4 * kBricks}) {
    const double reach = cellImage(cellsOf({&wall, 1}, count), 8).reach;
    CHECK(reach < 0.85 * before);
    before = reach;
  }
}

TEST_CASE("only the largest maps have cells") {
  const MapExemplar wall = wallOf({});
  const MapExemplar small = test::planeOf(64, 40, [](int x, int) { return float(x / 8 % 2); });
  const std::array<MapExemplar, 2> both{small, wall};
  CHECK(cellsOf(both, kBricks).toCentre == wallCells().toCentre);
}

TEST_CASE("the image of cells holds what points to centres over its reach, down to one texel") {
  const CellField& cells = wallCells();
  const CellImage image = cellImage(cells, 8);
  double reach = 0.0;
  for (const std::array<float, 2>& toCentre : cells.toCentre)
    reach = std::max({reach, std::abs(double(toCentre[0])), std::abs(double(toCentre[1]))});
  CHECK(image.reach == Approx(reach));
  CHECK(image.table.width == std::uint32_t(cells.width));
  CHECK(image.table.height == std::uint32_t(cells.height));
  CHECK(image.table.mipLevels == 8); // 128 x 80 to 1 x 1
  REQUIRE(image.table.format == TexelFormat::rgba8Unorm);
  const auto texel = [&](std::size_t i, std::size_t channel) {
    return double(std::to_integer<int>(image.table.texels[4 * i + channel])) / 255.0;
  };
  double most = 0.0;
  for (std::size_t i = 0; i < cells.toCentre.size(); ++i) {
    for (std::size_t axis = 0; axis < 2; ++axis)
      most = std::max(most, std::abs((2.0 * texel(i, axis) - 1.0) * image.reach -
                                     double(cells.toCentre[i][axis])));
    REQUIRE(texel(i, 2) == 1.0);
  }
  CHECK(most < 1.01 * image.reach / 255.0); // half a step of 2 / 255
}
