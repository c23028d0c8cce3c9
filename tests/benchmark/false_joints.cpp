// SPDX-License-Identifier: MIT
// Quilting and the exemplar's cells -> what each pixel of a result shows.
//
// The quilting blends two more maps with its weights: where the exemplar has joints, and
// positions in the exemplar. So the measure has no weights of its own, and no colours.
#include "false_joints.h"

#include "exemplars.h"
#include "synthesized.h"

#include <lichen/quilting.h>
#include <lichen/synthesize.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace lichen::bench {
namespace {

constexpr double kFullCircle = 2.0 * std::numbers::pi;

struct Pixel {
  int x = 0, y = 0;
  [[nodiscard]] auto operator<=>(const Pixel&) const = default;
};

int wrapped(int value, int side) { return (value % side + side) % side; }

/// A map of three values a pixel.
template <class ValuesAt>
MapExemplar mapOf(MapTarget target, std::vector<MapChannel> channels, int side,
                  const ValuesAt& valuesAt) {
  MapExemplar map;
  map.target = target;
  map.channels = std::move(channels);
  map.encoding = ValueEncoding::linear;
  map.width = map.height = side;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const std::array<float, 3> values = valuesAt(x, y);
      map.values.insert(map.values.end(), values.begin(), values.end());
    }
  return map;
}

/// The quilting's tiles and weights with other maps: joints and the position along x in
/// occlusion-roughness-metallic, the position along y in emissive. A position is an angle, stored
/// as its cosine and sine, since it wraps.
Bundle carryingPositions(const Bundle& quilting, const std::vector<int>& cells, int side) {
  const auto cosine = [&](int at) { return float(0.5 + 0.5 * std::cos(kFullCircle * at / side)); };
  const auto sine = [&](int at) { return float(0.5 + 0.5 * std::sin(kFullCircle * at / side)); };
  const std::array maps{
      mapOf(MapTarget::occlusionRoughnessMetallic,
            {MapChannel::occlusion, MapChannel::roughness, MapChannel::metallic}, side,
            [&](int x, int y) {
              const bool isJoint = cells[std::size_t(y) * std::size_t(side) + std::size_t(x)] < 0;
              return std::array{isJoint ? 1.0f : 0.0f, cosine(x), sine(x)};
            }),
      mapOf(MapTarget::emissive, {MapChannel::red, MapChannel::green, MapChannel::blue}, side,
            [&](int, int y) {
              return std::array{cosine(y), sine(y), 0.0f};
            })};
  QuiltingOptions options;
  options.periodic = Periodic::yes;
  options.bits = 16;
  Bundle bundle = bundleOf(bakeQuilting("positions", maps, options));
  const auto cellsOf = [](const Bundle& of) {
    return of.noises.front().maps.front().as<QuiltingMap>().cells;
  };
  bundle.tables[cellsOf(bundle)] = quilting.tables[cellsOf(quilting)];
  QuiltingNoise shared = quilting.noises.front().as<QuiltingNoise>();
  shared.correlation = 1.0; // the blend is then the weighted mean
  bundle.noises.front().data = shared;
  return bundle;
}

LinearImage resultOf(const Bundle& bundle, MapTarget map, int side, std::uint32_t seed) {
  SynthesisOptions options;
  options.material.seed = seed;
  options.map = map;
  options.width = options.height = side;
  return require(synthesize(bundle, options));
}

/// The position whose cosine and sine are stored, or -1 if the values are of several positions.
int positionOf(float cosine, float sine, int side) {
  constexpr double kLeastLength = 0.9; // a tenth of another tile, at most
  const double x = 2.0 * double(cosine) - 1.0, y = 2.0 * double(sine) - 1.0;
  if (std::hypot(x, y) < kLeastLength)
    return -1;
  return wrapped(int(std::lround(std::atan2(y, x) / kFullCircle * side)), side);
}

/// A pixel of a cell.
struct CellPixel {
  Pixel at; ///< from the cell's first pixel
  bool isInner = false;
};

/// A cell of the exemplar, which may continue at the opposite side.
struct Cell {
  Pixel first;
  std::vector<CellPixel> pixels;
};

/// The shorter of the steps from one column or row to another; the exemplar repeats.
int shortest(int step, int side) { return wrapped(step + side / 2, side) - side / 2; }

/// Whether all pixels around are of the same cell.
bool isInner(const std::vector<int>& cells, int side, int x, int y) {
  const auto numberAt = [&](int column, int row) {
    return cells[std::size_t(wrapped(row, side)) * std::size_t(side) +
                 std::size_t(wrapped(column, side))];
  };
  for (int row = y - kInnerPixels; row <= y + kInnerPixels; ++row)
    for (int column = x - kInnerPixels; column <= x + kInnerPixels; ++column)
      if (numberAt(column, row) != numberAt(x, y))
        return false;
  return true;
}

std::vector<Cell> cellsFrom(const std::vector<int>& cells, int side) {
  std::vector<Cell> result;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const int number = cells[std::size_t(y) * std::size_t(side) + std::size_t(x)];
      if (number < 0)
        continue;
      if (number == int(result.size())) // numbers are by first appearance
        result.push_back({{x, y}, {}});
      Cell& cell = result[std::size_t(number)];
      cell.pixels.push_back({{shortest(x - cell.first.x, side), shortest(y - cell.first.y, side)},
                             isInner(cells, side, x, y)});
    }
  return result;
}

} // namespace

FalseJoints falseJoints(const Bundle& quilting, const std::vector<int>& cells, int side,
                        int tilesPerSide, std::uint32_t seed) {
  const Bundle bundle = carryingPositions(quilting, cells, side);
  const int resultSide = tilesPerSide * side;
  const LinearImage left =
      resultOf(bundle, MapTarget::occlusionRoughnessMetallic, resultSide, seed);
  const LinearImage right = resultOf(bundle, MapTarget::emissive, resultSide, seed);
  const std::vector<Cell> shapes = cellsFrom(cells, side);
  // A cell in the result: its number, and where its first pixel is.
  std::map<std::pair<int, Pixel>, std::size_t> pixelsShown;
  for (int y = 0; y < resultSide; ++y)
    for (int x = 0; x < resultSide; ++x) {
      const int column = positionOf(left.pixel(x, y)[1], left.pixel(x, y)[2], side);
      const int row = positionOf(right.pixel(x, y)[0], right.pixel(x, y)[1], side);
      if (column < 0 || row < 0)
        continue;
      const int number = cells[std::size_t(row) * std::size_t(side) + std::size_t(column)];
      if (number < 0)
        continue;
      const Pixel first = shapes[std::size_t(number)].first;
      const Pixel start{x - shortest(column - first.x, side), y - shortest(row - first.y, side)};
      ++pixelsShown[{number, start}];
    }
  double joints = 0.0, all = 0.0, innerJoints = 0.0, inner = 0.0;
  for (const auto& [cell, count] : pixelsShown) {
    const Cell& shape = shapes[std::size_t(cell.first)];
    if (2 * count <= shape.pixels.size())
      continue;
    for (const CellPixel& pixel : shape.pixels) {
      const int x = cell.second.x + pixel.at.x, y = cell.second.y + pixel.at.y;
      if (x < 0 || y < 0 || x >= resultSide || y >= resultSide)
        continue;
      const double joint = left.pixel(x, y)[0] >= 0.5f ? 1.0 : 0.0;
      all += 1.0;
      joints += joint;
      if (pixel.isInner) {
        inner += 1.0;
        innerJoints += joint;
      }
    }
  }
  return {joints / std::max(all, 1.0), innerJoints / std::max(inner, 1.0),
          all / (double(resultSide) * resultSide)};
}

} // namespace lichen::bench
