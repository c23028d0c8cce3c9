// SPDX-License-Identifier: MIT
// The mip chain of the Gaussian image, and the levels of the table for the variance that it loses.
#include "baked_exemplar.h"

#include <lichen/image.h>
#include <lichen/tiling_map.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <gaussian/level_means.h>
#include <gaussian/mip_chain.h>
#include <gaussian/prefilter.h>
#include <gaussian/table_lookup.h>
#include <random>
#include <sampling/texels.h>
#include <transport/random.h>

using namespace lichen;
using namespace lichen::test;
using namespace lichen::gaussian;

namespace {

/// A normal variate from counted uniform numbers [BM58].
double deviate(std::uint64_t seed, std::uint64_t counter) {
  const double u = transport::randomUniform(seed, 2 * counter);
  const double v = transport::randomUniform(seed, 2 * counter + 1);
  return std::sqrt(-2.0 * std::log(1.0 - u)) * std::cos(6.283185307179586 * v);
}

} // namespace

TEST_CASE("each mip texel is the average of the area it covers, for any size") {
  // Odd and even sides, a side that reaches 1 first, D of 1 to 3. The slow average splits both
  // levels into the cells of their common grid and counts in integers.
  for (const auto& [width, height, dimensions] :
       {std::array{45, 23, 3}, std::array{7, 61, 2}, std::array{64, 3, 1}, std::array{32, 32, 3}}) {
    const auto count = std::size_t(width) * std::size_t(height);
    const Gaussianized noise{
        width,
        height,
        dimensions,
        gaussian::stratifiedGaussian(count, dimensions, gaussian::Precision::bits16),
        {}};
    const Table table = gaussianTable(noise, 16);
    const int channels = channelCount(table.format);
    REQUIRE(int(table.mipLevels) == int(std::bit_width(unsigned(std::max(width, height)))));
    for (std::uint32_t mip = 1; mip < table.mipLevels; ++mip) {
      INFO(width << " x " << height << ", mip " << mip);
      const std::vector<float> above = decodeLevel(table, mip - 1);
      const std::vector<float> level = decodeLevel(table, mip);
      const auto side = [mip](int full, std::uint32_t back) {
        return std::max(1, full >> (mip - back));
      };
      const int aboveWidth = side(width, 1), aboveHeight = side(height, 1);
      const int levelWidth = side(width, 0), levelHeight = side(height, 0);
      std::vector<double> sums(level.size(), 0.0);
      for (int y = 0; y < aboveHeight * levelHeight; ++y)
        for (int x = 0; x < aboveWidth * levelWidth; ++x)
          for (int c = 0; c < channels; ++c)
            sums[std::size_t((y / aboveHeight * levelWidth + x / aboveWidth) * channels + c)] +=
                double(above[std::size_t(
                    (y / levelHeight * aboveWidth + x / levelWidth) * channels + c)]);
      // A half float below 2 has an error of at most 2^-11, and so have the half floats averaged
      // here.
      const float loss = level[std::size_t(channels - 1)];
      for (std::size_t i = 0; i < level.size(); ++i)
        if (int(i) % channels == channels - 1)
          REQUIRE(level[i] == loss); // the same in all texels of a level
        else
          REQUIRE(double(level[i]) ==
                  Approx(sums[i] / (aboveWidth * aboveHeight)).margin(std::exp2(-10)));
    }
  }
}

namespace {

/// The table of roots of an exemplar, with the Gaussian image, its losses and the table's levels.
struct Levels {
  InverseTable table;
  Table image;
  std::vector<float> losses;
  std::vector<InverseTable> levels;
};

Levels levelsOf(const Baked& b, bool restored = true) {
  const int channels = int(b.map.channels.size());
  Levels result;
  result.table = fitInverseTable(b.gaussian, b.points, tableValues(b.map), channels, {});
  result.image = gaussianTable(b.gaussian, 16);
  result.losses = fetchLosses(result.image);
  result.levels =
      prefilteredLevels(result.table, lostVariance(result.image, b.gaussian.dimensions), true);
  if (restored)
    restoreLevelMeans(result.levels, true, result.image, result.losses);
  return result;
}

/// The means of the exemplar's light.
exemplar::ChannelVector meanLight(const MapExemplar& map) {
  std::vector<float> values = map.values;
  std::transform(values.begin(), values.end(), values.begin(), srgbToLinear);
  return exemplar::momentsOf(values, int(map.channels.size())).mean;
}

/// Red of the three materials: a table of one axis.
MapExemplar redMaterials(int side, std::uint64_t seed) {
  MapExemplar map = threeMaterials(side, side, seed);
  for (std::size_t i = 0; i < map.values.size() / 3; ++i)
    map.values[i] = map.values[3 * i];
  map.values.resize(map.values.size() / 3);
  map.channels = {MapChannel::red};
  return map;
}

} // namespace

TEST_CASE("squares of lookups average to the mean light at every level") {
  // In random order, the pixels' mips are Gaussian, and the mean over a level's Gaussian values is
  // an integral over quantiles.
  Baked b = baked(redMaterials(256, 4));
  for (std::size_t i = b.gaussian.image.size(); i-- > 1;)
    std::swap(b.gaussian.image[i], b.gaussian.image[transport::randomBits(3, i) % (i + 1)]);
  const double wanted = meanLight(b.map)[0];
  const auto meanOf = [](const InverseTable& level, int k) {
    constexpr int kPlaces = 4096;
    std::array<double, 2> mean{}; // of squares and of their squares
    for (int n = 0; n < kPlaces; ++n) {
      const double g =
          0.5 + retainedAmplitude(k) * (gaussian::gaussianQuantile((n + 0.5) / kPlaces) - 0.5);
      const double root = slowLookup(level, {g, 0.0, 0.0}, 0);
      mean[0] += root * root / kPlaces;
      mean[1] += root * root * root * root / kPlaces;
    }
    return mean;
  };
  const Levels unrestored = levelsOf(b, false), restored = levelsOf(b);
  REQUIRE(restored.levels.size() == std::size_t(kTableLevels));
  for (int k = 0; k < kTableLevels; ++k) {
    const auto before = meanOf(unrestored.levels[std::size_t(k)], k);
    const auto after = meanOf(restored.levels[std::size_t(k)], k);
    INFO("level " << k << ": " << before[0] << " before the means are restored, " << after[0]
                  << " after, of " << wanted);
    // A fit of roots has less mean light by its own mean square error, at most 0.002 here.
    CHECK(before[0] == Approx(wanted).margin(0.002));
    // Five standard errors of the 65,536 fetches that measure the shift.
    CHECK(after[0] ==
          Approx(wanted).margin(1e-4 + 5.0 * std::sqrt((after[1] - after[0] * after[0]) / 65536)));
  }
}

TEST_CASE("averaging blurs a step along any axis as the Gaussian does", "[large]") {
  constexpr int kPlaces = 4096;
  for (int dimensions = 1; dimensions <= 3; ++dimensions)
    for (int axis = 0; axis < dimensions; ++axis) {
      InverseTable table{dimensions, kTableSide[std::size_t(dimensions - 1)], 1, {}};
      const auto side = std::size_t(table.side);
      std::size_t stride = 1;
      for (int k = 0; k < axis; ++k)
        stride *= side;
      const auto cells = std::size_t(std::lround(std::pow(double(side), dimensions)));
      for (std::size_t cell = 0; cell < cells; ++cell)
        table.values.push_back(cell / stride % side < side / 2 ? 0.0f : 1.0f);
      double worst = 0.0;
      for (int k = 1; k < kTableLevels; ++k) {
        const double loss = levelLoss(k);
        const InverseTable blurred =
            averaged(table, loss * exemplar::ChannelMatrix::Identity(dimensions, dimensions));
        for (std::size_t place = 0; place < side; ++place) {
          const double middle = gaussian::gaussianQuantile((double(place) + 0.5) / double(side));
          double mean = 0.0;
          for (int n = 0; n < kPlaces; ++n) {
            const double displaced =
                middle + std::sqrt(loss) * (gaussian::gaussianQuantile((n + 0.5) / kPlaces) - 0.5);
            // The step, interpolated between the two cells that it separates.
            const double coordinate = double(side) * gaussian::gaussianCdf(displaced) - 0.5;
            mean += std::clamp(coordinate - double(side / 2 - 1), 0.0, 1.0) / kPlaces;
          }
          worst = std::max(worst, std::abs(double(blurred.values[place * stride]) - mean));
        }
      }
      INFO(dimensions << " dimensions, axis " << axis);
      // The weights are sampled at 256 positions on the axis; the tolerance is one of them.
      CHECK(worst < 1.0 / 256.0);
    }
}

TEST_CASE("an averaged cell is the expectation of the table over the variance that a fetch loses") {
  const Baked b = baked(threeMaterials(96, 96, 4));
  const InverseTable table = fitInverseTable(b.gaussian, b.points, tableValues(b.map), 3, {});
  exemplar::ChannelMatrix half(
      3, 3); // of the variance, for channels whose losses differ and correlate
  half << 0.7, 0.15, 0.0, 0.15, 0.5, -0.1, 0.0, -0.1, 0.3;
  // Below the first mip level, losses are in proportion to its own.
  const exemplar::ChannelMatrix loss = half * (levelLoss(1) / scalarLoss(half));
  CHECK((lossAt(levelLoss(1), {half}) - loss).norm() < 1e-12);
  const InverseTable average = averaged(table, loss);
  const Eigen::LLT<exemplar::ChannelMatrix> factor(loss);
  const exemplar::ChannelMatrix lower = factor.matrixL();
  constexpr int kSamples = 1500;
  for (const std::size_t cell : {std::size_t(16912), std::size_t(9000), std::size_t(23456)}) {
    std::array<double, 3> middle{};
    std::size_t rest = cell;
    for (double& coordinate : middle) {
      coordinate = gaussian::gaussianQuantile((double(rest % 32) + 0.5) / 32.0);
      rest /= 32;
    }
    double sum = 0.0;
    double squares = 0.0;
    for (int s = 0; s < kSamples; ++s) {
      exemplar::ChannelVector z(3);
      for (int c = 0; c < 3; ++c)
        z[c] = deviate(17, std::uint64_t(3 * s + c)) / 6.0;
      const exemplar::ChannelVector e = lower * z;
      const double value =
          slowLookup(table, {middle[0] + e[0], middle[1] + e[1], middle[2] + e[2]}, 0);
      sum += value;
      squares += value * value;
    }
    const double mean = sum / kSamples;
    const double deviationOfValue = std::sqrt(std::max(0.0, squares / kSamples - mean * mean));
    // Five standard errors of the Monte Carlo mean, alpha 6e-7, and of the cell's own 32 samples.
    // Their error is a fifth of independent samples' error: they are stratified, and contribute
    // only where the directions lose differently.
    const double tolerance =
        5.0 * deviationOfValue * (1.0 / std::sqrt(double(kSamples)) + 0.2 / std::sqrt(32.0));
    CHECK(double(average.values[3 * cell]) == Approx(mean).margin(tolerance));
  }
}

TEST_CASE("each level of a table has half as many cells as the one before, and the first is the "
          "table itself") {
  const Levels t = levelsOf(baked(redMaterials(64, 4)));
  REQUIRE(t.levels.size() == std::size_t(kTableLevels));
  CHECK(t.levels.front().values == t.table.values);
  for (std::size_t k = 0; k < t.levels.size(); ++k) {
    CHECK(t.levels[k].side == 256 >> k);
    CHECK(t.levels[k].cellCount() == std::size_t(256) >> k);
  }
}
