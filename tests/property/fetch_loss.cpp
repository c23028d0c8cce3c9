// SPDX-License-Identifier: MIT
// The losses that a Gaussian image stores against fetches of it at random positions, and against
// the closed form of white noise.
#include "baked_exemplar.h"

#include <lichen/tiling_map.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <gaussian/mip_chain.h>
#include <random>
#include <string>
#include <transport/random.h>

using namespace lichen;
using namespace lichen::test;
using namespace lichen::gaussian;

namespace {

Gaussianized whiteImage(int side) {
  const auto count = std::size_t(side) * std::size_t(side);
  Gaussianized white{
      side, side, 3, gaussian::stratifiedGaussian(count, 3, gaussian::Precision::bits16), {}};
  for (std::size_t i = count; i-- > 1;)
    std::swap(white.image[i], white.image[transport::randomBits(5, i) % (i + 1)]);
  return white;
}

/// Rows are alike, and every column is independent of its neighbours.
Gaussianized stripedImage(int side) {
  Gaussianized striped{side, side, 1, {}, {}};
  std::vector<Point> row =
      gaussian::stratifiedGaussian(std::size_t(side), 1, gaussian::Precision::bits16);
  for (std::size_t i = row.size(); i-- > 1;)
    std::swap(row[i], row[transport::randomBits(6, i) % (i + 1)]);
  for (int y = 0; y < side; ++y)
    striped.image.insert(striped.image.end(), row.begin(), row.end());
  return striped;
}

/// The texels of a table, fetched as a repeating trilinear sampler does, in double precision.
class SlowImage {
public:
  explicit SlowImage(const Table& table)
      : width_(int(table.width)), height_(int(table.height)),
        channels_(channelCount(table.format)) {
    for (std::uint32_t mip = 0; mip < table.mipLevels; ++mip)
      mips_.push_back(decodeLevel(table, mip));
  }
  [[nodiscard]] double at(double u, double v, double level, int channel) const {
    const auto fine = std::min(std::size_t(level), mips_.size() - 1);
    const auto coarse = std::min(fine + 1, mips_.size() - 1);
    const double t = level - double(fine);
    return (1.0 - t) * bilinear(u, v, fine, channel) + t * bilinear(u, v, coarse, channel);
  }

private:
  [[nodiscard]] double bilinear(double u, double v, std::size_t mip, int channel) const {
    const int width = std::max(1, width_ >> mip), height = std::max(1, height_ >> mip);
    const double x = u * width - 0.5, y = v * height - 0.5;
    double sum = 0.0;
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i) {
        const int column = (int(std::floor(x)) + i + width) % width;
        const int row = (int(std::floor(y)) + j + height) % height;
        sum += std::abs(1 - i - (x - std::floor(x))) * std::abs(1 - j - (y - std::floor(y))) *
               double(mips_[mip][std::size_t((row * width + column) * channels_ + channel)]);
      }
    return sum;
  }

  int width_, height_, channels_;
  std::vector<std::vector<float>> mips_;
};

struct Measured {
  double loss = 0.0, standardError = 0.0;
};

/// The loss of fetches at random positions.
Measured measuredLoss(const SlowImage& image, int dimensions, double whole, double level, int count,
                      std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> anywhere;
  double sum = 0.0, squares = 0.0;
  for (int k = 0; k < count; ++k) {
    const double u = anywhere(random), v = anywhere(random);
    double kept = 0.0;
    for (int c = 0; c < dimensions; ++c)
      kept += std::pow(image.at(u, v, level, c) - double(kStoredGaussianMean), 2) / dimensions;
    sum += kept / whole / count;
    squares += kept / whole * kept / whole / count;
  }
  return {1.0 - sum, std::sqrt(std::max(0.0, squares - sum * sum) / count)};
}

struct NamedImage {
  std::string name;
  Gaussianized image;
};

std::vector<NamedImage> images() {
  return {{"white noise", whiteImage(128)},
          {"three materials", baked(threeMaterials(128, 128, 4)).gaussian},
          {"stripes", stripedImage(256)}};
}

/// The variance of a channel of level 0, about the mean.
double wholeVariance(const Table& table, int dimensions) {
  const std::vector<float> texels = decodeLevel(table, 0);
  const auto channels = std::size_t(channelCount(table.format));
  double sum = 0.0;
  for (std::size_t i = 0; i < texels.size(); ++i)
    if (i % channels < std::size_t(dimensions))
      sum += std::pow(double(texels[i]) - double(kStoredGaussianMean), 2);
  return sum / (double(texels.size()) / double(channels) * dimensions);
}

} // namespace

TEST_CASE("interpolation of white noise loses 5/9 of the variance, and of stripes a third") {
  // E[(1 - f)^2 + f^2] = 2/3 along each axis on which neighbours are independent. They are a sample
  // of n pairs: a standard error of 1 / sqrt(n) for each lag's correlation.
  const auto lossOf = [](const Gaussianized& image) {
    return fetchLoss(gaussianTable(image, 16), image.dimensions).front();
  };
  CHECK(lossOf(whiteImage(256)) == Approx(5.0 / 9.0).margin(5.0 * (6.0 / 9.0) / (256.0 * 1.7)));
  CHECK(lossOf(stripedImage(4096)) == Approx(1.0 / 3.0).margin(5.0 * (1.0 / 3.0) / 64.0));
}

TEST_CASE("a Gaussian image stores the loss of fetches at random positions", "[large]") {
  constexpr int kPositions = 100000;
  for (const NamedImage& one : images()) {
    const int dimensions = one.image.dimensions;
    const Table table = gaussianTable(one.image, 16);
    const SlowImage image(table);
    const std::vector<float> losses = fetchLosses(table);
    REQUIRE(losses.size() == table.mipLevels);
    const double whole = wholeVariance(table, dimensions);
    const Measured interpolation = measuredLoss(image, dimensions, whole, 0.0, kPositions, 1);
    INFO(one.name);
    // Five standard errors, alpha 6e-7, and half floats.
    constexpr double kHalf = 0x1p-11;
    CHECK(double(losses[0]) ==
          Approx(interpolation.loss).margin(5.0 * interpolation.standardError + kHalf));
    for (std::size_t m = 0; m + 1 < losses.size(); ++m)
      for (const double t : {0.25, 0.5, 0.75, 1.0}) {
        const Measured found =
            measuredLoss(image, dimensions, whole, double(m) + t, kPositions, std::uint32_t(m + 2));
        const double stored = double(losses[m]) + t * double(losses[m + 1] - losses[m]);
        INFO("level " << double(m) + t << ": lost " << found.loss << " +- " << found.standardError
                      << ", stored " << stored);
        // Between levels the loss is a parabola, and lines that meet follow it. White noise bends
        // most: measured 0.049 in the middle of the first piece, whose first end is given.
        constexpr double kDeviation = 0.05;
        CHECK(stored == Approx(found.loss).margin(kDeviation + 5.0 * found.standardError));
      }
  }
}

TEST_CASE("no other losses of the levels follow the losses of fetches better, in the mean square") {
  // Least squares: what the interpolated losses leave is orthogonal to the hat of each level.
  constexpr int kSteps = 16, kPositions = 8000;
  for (const NamedImage& one : images()) {
    const int dimensions = one.image.dimensions;
    const Table table = gaussianTable(one.image, 16);
    const SlowImage image(table);
    const std::vector<float> losses = fetchLosses(table);
    const double whole = wholeVariance(table, dimensions);
    std::vector<double> left(losses.size(), 0.0), errors(losses.size(), 0.0);
    for (std::size_t m = 0; m + 1 < losses.size(); ++m)
      for (int k = 0; k < kSteps; ++k) {
        const double t = (k + 0.5) / kSteps;
        const Measured found = measuredLoss(image, dimensions, whole, double(m) + t, kPositions,
                                            std::uint32_t(100 * m) + std::uint32_t(k));
        const double rest = double(losses[m]) + t * double(losses[m + 1] - losses[m]) - found.loss;
        for (const auto& [level, hat] : {std::pair{m, 1.0 - t}, {m + 1, t}}) {
          left[level] += hat * rest / kSteps;
          errors[level] += std::pow(hat * found.standardError / kSteps, 2);
        }
      }
    for (std::size_t m = 1; m < losses.size(); ++m) { // level 0 has its own loss
      if (double(losses[m]) > 0.999)
        break; // all is lost, and losses are clamped
      INFO(one.name << ", level " << m << ": " << left[m] << " +- " << std::sqrt(errors[m]));
      // Five standard errors, half floats, and what 32,768 positions of the bake leave: 0.001.
      CHECK(std::abs(left[m]) < 5.0 * std::sqrt(errors[m]) + 0.001);
    }
  }
}
