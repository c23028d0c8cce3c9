// SPDX-License-Identifier: MIT
// The mip chain of the Gaussian image, and the table's slabs for the variance that it loses.
#include "baked_exemplar.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <random>
#include <tiling/mip_chain.h>
#include <tiling/prefilter.h>
#include <tiling/slab_means.h>
#include <tiling/table_lookup.h>
#include <transport/random.h>

using namespace lichen;
using namespace lichen::test;
using namespace lichen::tiling;

namespace {

/// A normal variate from counted uniform numbers [BM58].
double deviate(std::uint64_t seed, std::uint64_t counter) {
  const double u = transport::randomUniform(seed, 2 * counter);
  const double v = transport::randomUniform(seed, 2 * counter + 1);
  return std::sqrt(-2.0 * std::log(1.0 - u)) * std::cos(6.283185307179586 * v);
}

} // namespace

TEST_CASE("mips of white noise lose the variance that averaging removes", "[large]") {
  // Each mip averages four independent texels: it keeps a quarter of the variance of the level
  // before.
  Gaussianized white{
      256, 256, 3, gaussian::stratifiedGaussian(256 * 256, 3, gaussian::Precision::bits16), {}};
  for (std::size_t i = white.image.size(); i-- > 1;)
    std::swap(white.image[i], white.image[transport::randomBits(5, i) % (i + 1)]);
  const std::vector<exemplar::ChannelMatrix> lost = lostVariance(gaussianTable(white, 16));
  REQUIRE(lost.size() == 9);
  CHECK(scalarLoss(lost[0]) == 0.0);
  for (std::size_t mip = 1; mip < 5; ++mip) {
    const double kept = std::pow(0.25, double(mip));
    // The mean of three sample variances over n texels has the standard error
    // `kept` * sqrt(2 / (3 n)). The limit is five of these: false alarms below 1e-6 per level.
    const double texels = 65536.0 * kept;
    CHECK(1.0 - scalarLoss(lost[mip]) ==
          Approx(kept).margin(5.0 * kept * std::sqrt(2.0 / (3.0 * texels))));
  }
}

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
      for (std::size_t i = 0; i < level.size(); ++i)
        REQUIRE(double(level[i]) ==
                Approx(sums[i] / (aboveWidth * aboveHeight)).margin(std::exp2(-10)));
    }
  }
}

TEST_CASE("blended mips decode to the mean colour, Gaussian or not", "[large]") {
  const Baked b = baked(threeMaterials(128, 128, 4));
  const InverseTable table =
      fitInverseTable(b.gaussian, b.points, light(b.map), 3, transport::TransportOptions{});
  const Table image = gaussianTable(b.gaussian, 16);
  const std::vector<exemplar::ChannelMatrix> lost = lostVariance(image);
  std::vector<InverseTable> slabs = prefilteredSlabs(table, lost);
  restoreSlabMeans(slabs, image, lost);
  // Between the slabs of two mips the mean is interpolated like the values.
  constexpr std::uint32_t kMip = 2;
  const std::vector<float> texels = decodeLevel(image, kMip);
  const std::size_t count = texels.size() / 4;
  const double place = 7.0 * (1.0 - std::sqrt(1.0 - scalarLoss(lost[kMip])));
  const auto slab = std::size_t(place);
  const TableLookup<3> lower(slabs[slab]);
  const TableLookup<3> upper(slabs[slab + 1]);
  std::mt19937 random(11);
  std::uniform_int_distribution<std::size_t> anywhere(0, count - 1);
  std::exponential_distribution<double> exponential; // three, normalized: uniform in a triangle
  constexpr int kSamples = 200000;
  std::array<double, 3> sum{};
  std::array<double, 3> squares{};
  for (int k = 0; k < kSamples; ++k) {
    std::array<double, 3> w{exponential(random), exponential(random), exponential(random)};
    const double total = w[0] + w[1] + w[2];
    const double norm = std::sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]) / total;
    std::array<float, 3> g{0.5f, 0.5f, 0.5f};
    for (const double weight : w) {
      const float* texel = &texels[4 * anywhere(random)];
      for (std::size_t c = 0; c < 3; ++c)
        g[c] += float(weight / total / norm) * (texel[c] - 0.5f);
    }
    const auto low = lower(g);
    const auto high = upper(g);
    for (std::size_t c = 0; c < 3; ++c) {
      const double value = double(low[c]) + (place - double(slab)) * double(high[c] - low[c]);
      sum[c] += value;
      squares[c] += value * value;
    }
  }
  for (std::size_t c = 0; c < 3; ++c) {
    const double mean = sum[c] / kSamples;
    const double variance = squares[c] / kSamples - mean * mean;
    // Five standard errors of this sum and of the 65,536 fetches that measure the shift. The slabs
    // below and above are shifted for their own positions between mips.
    const double error = 5.0 * std::sqrt(variance * (1.0 / kSamples + 1.0 / 65536.0));
    INFO("mean " << mean << ", slab mean " << slabs.back().values[c] << ", error " << error);
    CHECK(mean == Approx(double(slabs.back().values[c])).margin(error));
  }
}

TEST_CASE("slabs blur a step along any axis as the Gaussian does", "[large]") {
  constexpr int kPlaces = 4096;
  const std::vector<double> levels = tableLevels();
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
      const std::vector<exemplar::ChannelMatrix> lost{
          exemplar::ChannelMatrix::Zero(dimensions, dimensions),
          exemplar::ChannelMatrix::Identity(dimensions, dimensions)};
      const std::vector<InverseTable> slabs = prefilteredSlabs(table, lost);
      double worst = 0.0;
      for (std::size_t k = 1; k + 1 < levels.size(); ++k)
        for (std::size_t place = 0; place < side; ++place) {
          const double middle = gaussian::gaussianQuantile((double(place) + 0.5) / double(side));
          double mean = 0.0;
          for (int n = 0; n < kPlaces; ++n) {
            const double displaced =
                middle +
                std::sqrt(levels[k]) * (gaussian::gaussianQuantile((n + 0.5) / kPlaces) - 0.5);
            // The step, interpolated between the two cells that it separates.
            const double coordinate = double(side) * gaussian::gaussianCdf(displaced) - 0.5;
            mean += std::clamp(coordinate - double(side / 2 - 1), 0.0, 1.0) / kPlaces;
          }
          worst = std::max(worst, std::abs(double(slabs[k].values[place * stride]) - mean));
        }
      INFO(dimensions << " dimensions, axis " << axis);
      // The weights are sampled at 256 positions on the axis; the tolerance is one of them.
      CHECK(worst < 1.0 / 256.0);
    }
}

TEST_CASE("a slab stores the expectation of the table over the variance that a fetch loses") {
  const Baked b = baked(threeMaterials(96, 96, 4));
  const InverseTable table =
      fitInverseTable(b.gaussian, b.points, light(b.map), 3, transport::TransportOptions{});
  exemplar::ChannelMatrix half(
      3, 3); // of the variance, for channels whose losses differ and correlate
  half << 0.7, 0.15, 0.0, 0.15, 0.5, -0.1, 0.0, -0.1, 0.3;
  const std::vector<double> levels = tableLevels();
  const std::vector<InverseTable> slabs = prefilteredSlabs(table, {half});
  REQUIRE(slabs.size() == levels.size());
  CHECK(slabs.front().values == table.values);

  constexpr std::size_t kSlab = 2;
  const exemplar::ChannelMatrix loss = half * (levels[kSlab] / scalarLoss(half));
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
    // Five standard errors of the Monte Carlo mean, alpha 6e-7, and of the slab's own 32 samples.
    // Their error is a fifth of that of independent samples: they are stratified, and contribute
    // only where the directions lose differently.
    const double tolerance =
        5.0 * deviationOfValue * (1.0 / std::sqrt(double(kSamples)) + 0.2 / std::sqrt(32.0));
    CHECK(double(slabs[kSlab].values[3 * cell]) == Approx(mean).margin(tolerance));
  }
  const exemplar::Moments moments = interpolatedMoments(table);
  for (std::size_t c = 0; c < 3; ++c)
    CHECK(double(slabs.back().values[c]) == Approx(moments.mean[Eigen::Index(c)]).epsilon(1e-5));
}
