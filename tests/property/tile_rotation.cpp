// SPDX-License-Identifier: MIT
// Tiling with rotated tiles: evenly hashed rotations, and slopes that match the rotated height.
#include <lichen/lattice.h>
#include <lichen/shader_parameters.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <evaluation/method_evaluator.h>
#include <numbers>
#include <vector>

using namespace lichen;

namespace {

/// The values of tileRotation that rotate the tiles of an exemplar of this size.
std::vector<std::uint32_t> anglesOf(std::uint32_t width, std::uint32_t height) {
  return width == height ? std::vector{2u, 4u} : std::vector{2u};
}

MaterialNoise rotatedBy(std::uint32_t angles) {
  MaterialNoise material;
  material.tileRotation = angles;
  return material;
}

/// Height per texel at (x, y) texels, with whole periods in the exemplar, and its derivatives.
struct Wave {
  double height, alongX, alongDown;
};
using WaveAt = Wave (*)(double x, double y, double width, double height);

/// Two oblique waves of different lengths: no rotation maps the sum onto itself.
Wave slanted(double x, double y, double width, double height) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const double ax = 2.0 * kTurn / width, ay = kTurn / height;
  const double bx = kTurn / width, by = -3.0 * kTurn / height;
  const double a = ax * x + ay * y, b = bx * x + by * y;
  return {3.0 * std::sin(a) + std::cos(b), 3.0 * ax * std::cos(a) - bx * std::sin(b),
          3.0 * ay * std::cos(a) - by * std::sin(b)};
}

/// A noise of the wave's slopes and height, without tables, mips or losses: values are affine in
/// what is fetched.
Bundle waveBundle(WaveAt wave, std::uint32_t width, std::uint32_t height) {
  constexpr double kSlopeDeviation = 0.05, kHeightDeviation = 0.04, kHeightScale = 0.02;
  std::vector<float> slopes, heights;
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x) {
      const Wave at = wave(x + 0.5, y + 0.5, width, height);
      const auto texel = [](double value, double deviation) {
        return kStoredGaussianMean + float(value / (6.0 * deviation));
      };
      slopes.insert(slopes.end(), {texel(at.alongX, kSlopeDeviation),
                                   texel(-at.alongDown, kSlopeDeviation), 0.0f, 0.0f}); // y up
      heights.insert(heights.end(),
                     {texel(kHeightScale * at.height, kHeightDeviation), 0.0f, 0.0f, 0.0f});
    }
  Bundle bundle;
  Noise noise;
  noise.name = "wave";
  const auto add = [&](MapTarget target, const std::vector<float>& texels,
                       const NoiseMap& described) {
    Table table;
    table.format = TexelFormat::rgba32Sfloat;
    table.width = width;
    table.height = height;
    appendTexels(table.texels, table.format, texels);
    NoiseMap map = described;
    map.target = target;
    map.as<TilingMap>().gaussian = bundle.tables.size();
    map.as<TilingMap>().dimensions = int(map.channels.size());
    bundle.tables.push_back(std::move(table));
    noise.maps.push_back(std::move(map));
  };
  constexpr double kSlopeVariance = kSlopeDeviation * kSlopeDeviation;
  NoiseMap slope;
  slope.channels = {MapChannel::slopeX, MapChannel::slopeY};
  slope.encoding = ValueEncoding::slope;
  slope.mean = {0.0, 0.0};
  slope.covariance = {kSlopeVariance, 0.0, 0.0, kSlopeVariance};
  NoiseMap relief;
  relief.channels = {MapChannel::height};
  relief.encoding = ValueEncoding::linear;
  relief.mean = {0.5};
  relief.covariance = {kHeightDeviation * kHeightDeviation};
  add(MapTarget::normal, slopes, slope);
  add(MapTarget::height, heights, relief);
  bundle.noises = {std::move(noise)};
  return bundle;
}

/// For the height in waveBundle(), per texel.
constexpr double kHeightPerValue = 1.0 / 0.02;

TileFootprint pointAt(double x, double y, double side = 1e-4) {
  TileFootprint at;
  at.position = {float(x), float(y)};
  at.dx = {float(side), 0.0f};
  at.dy = {0.0f, float(side)};
  return at;
}

TileFootprint randomPoint(std::uint32_t k, double tiles) {
  const auto random = pcg3d({k, 31u, 32u});
  return pointAt(tiles * (random[0] * 0x1p-32 - 0.5), tiles * (random[1] * 0x1p-32 - 0.5));
}

/// The weight of the nearest vertex, of blend sharpness 1.
double nearestWeight(const TileFootprint& at) {
  const double row = double(at.position[1]) * kLatticeRowsPerTile;
  const double column = double(at.position[0]) * kLatticeColumnsPerTile - 0.5 * row;
  const double f = column - std::floor(column), g = row - std::floor(row);
  return f + g < 1.0 ? std::max({1.0 - f - g, f, g}) : std::max({f + g - 1.0, 1.0 - g, 1.0 - f});
}

/// The value that a chi-square variable exceeds once in a million [WH31].
double chiSquareLimit(double degrees) {
  constexpr double kDeviations = 4.753;
  const double ninth = 2.0 / (9.0 * degrees);
  return degrees * std::pow(1.0 - ninth + kDeviations * std::sqrt(ninth), 3.0);
}

double chiSquare(const std::vector<int>& counts) {
  double sum = 0.0, squares = 0.0;
  for (const int count : counts)
    sum += count;
  const double expected = sum / double(counts.size());
  for (const int count : counts)
    squares += (count - expected) * (count - expected) / expected;
  return squares;
}

} // namespace

TEST_CASE("tile rotations are uniform, and independent of neighbours and offsets") {
  // One false alarm in a million each; 18 comparisons in all.
  for (const std::uint32_t seed : {1u, 2u, 77u})
    for (const std::uint32_t angles : {2u, 4u}) {
      std::vector<int> one(angles), pairs(angles * angles), withOffset(4 * angles);
      constexpr std::uint32_t kSide = 256;
      const std::uint32_t word = latticeSeed(seed, 0);
      const auto angleOf = [&](std::uint32_t i, std::uint32_t j) {
        const std::uint32_t quarters = tileQuarterTurns(i, j, word, angles);
        REQUIRE(quarters < 4);
        REQUIRE(quarters * angles % 4 == 0);
        return quarters * angles / 4;
      };
      for (std::uint32_t j = 0; j < kSide; ++j)
        for (std::uint32_t i = 0; i < kSide; ++i) {
          const std::uint32_t angle = angleOf(i, j);
          ++one[angle];
          ++pairs[angles * angle + angleOf(i + kSide, j + 1)];
          ++withOffset[4 * angle + (tileOffsetSteps(i, j, word)[0] & 3u)];
        }
      INFO("seed " << seed << ", angles " << angles);
      for (const std::vector<int>& counts : {one, pairs, withOffset})
        CHECK(chiSquare(counts) < chiSquareLimit(double(counts.size()) - 1.0));
    }
}

TEST_CASE("slopes are the gradient of the height, rotated with its tiles") {
  // Near vertices and with the sharpest blend, where other tiles have less than 1e-4 of the weight:
  // a gradient of weights is not one of the exemplar's.
  constexpr double kNear = 0.7;
  for (const auto& [width, height] : {std::pair{256u, 256u}, {256u, 128u}, {128u, 256u}}) {
    const Bundle bundle = waveBundle(slanted, width, height);
    const auto evaluator = methodEvaluator(bundle, 0);
    for (const std::uint32_t angles : anglesOf(width, height)) {
      MaterialNoise sharp = rotatedBy(angles);
      sharp.blendSharpness = kBlendSharpnessRange.most;
      const shader::LichenTriplanarMaterial material = shaderMaterial(bundle, sharp, {});
      int compared = 0;
      double largest = 0.0;
      for (std::uint32_t k = 0; k < 6000; ++k) {
        const TileFootprint at = randomPoint(k, 12.0);
        if (nearestWeight(at) < kNear)
          continue;
        const auto moved = [&](double texelsX, double texelsY) {
          TileFootprint there = at;
          there.position[0] += float(texelsX / width);
          there.position[1] += float(texelsY / height);
          return there;
        };
        const std::array neighbours{moved(2, 0), moved(-2, 0), moved(0, 2), moved(0, -2)};
        std::array<double, 4> heights{};
        for (std::size_t n = 0; n < 4; ++n)
          heights[n] = kHeightPerValue * double(evaluator->evaluate(1, material, neighbours[n])[0]);
        const auto slopes = evaluator->evaluate(0, material, at);
        const double alongX = (heights[0] - heights[1]) / 4.0;
        const double alongDown = (heights[2] - heights[3]) / 4.0;
        largest = std::max(largest, std::hypot(double(slopes[0]) - alongX,
                                               double(slopes[1]) + alongDown)); // y up
        ++compared;
      }
      INFO(width << " x " << height << ", angles " << angles);
      CHECK(compared > 1000);
      // Slopes of up to 0.2 and 0.3, from differences over 4 texels in waves of at least 64 texels.
      // Their relative error is (2 pi 2 / 64)^2 / 6; interpolation and half floats add as much
      // again.
      CHECK(largest < 0.005);
    }
  }
}
