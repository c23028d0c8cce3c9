// SPDX-License-Identifier: MIT
// Gaussian image (width * height points) -> mip chain -> lost covariance of each mip level.
#include "mip_chain.h"

#include "exemplar/planes.h"
#include "sampling/texels.h"
#include "table_lookup.h"

#include <lichen/gaussian_image.h>

#include <Eigen/Dense>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lichen::gaussian {
namespace {

/// Covariance of the first `channels` of `stride` interleaved values.
exemplar::ChannelMatrix covarianceOf(const std::vector<float>& values, int stride, int channels) {
  const auto at = [&](std::size_t i, int c) {
    return values[i * std::size_t(stride) + std::size_t(c)];
  };
  return transport::momentsOf<exemplar::ChannelMatrix>(values.size() / std::size_t(stride),
                                                       channels, at)
      .covariance;
}

/// A Gaussian image whose variance, normally 1/36, is below this is constant up to the rounding of
/// the sums.
constexpr double kNoVariance = 1e-12;

TexelFormat formatOf(int dimensions, int bits) {
  if (dimensions == 1)
    return bits == 8 ? TexelFormat::rg8Unorm : TexelFormat::rg16Sfloat;
  return bits == 8 ? TexelFormat::rgba8Unorm : TexelFormat::rgba16Sfloat;
}

/// Sets the last channel of each mip level.
void setLoss(Table& table, const std::vector<double>& losses) {
  const std::size_t texel = texelBytes(table.format);
  const bool isHalf = texel > std::size_t(channelCount(table.format));
  for (std::uint32_t mip = 0; mip < table.mipLevels; ++mip) {
    std::vector<std::byte> loss;
    appendTexels(loss, isHalf ? TexelFormat::r16Sfloat : TexelFormat::r8Unorm,
                 std::array{float(losses[mip])});
    const LevelRange range = levelRange(table, mip);
    for (std::size_t end = texel; end <= range.size; end += texel)
      std::copy(loss.begin(), loss.end(),
                table.texels.begin() + std::ptrdiff_t(range.offset + end - loss.size()));
  }
}

} // namespace

Table gaussianTable(const Gaussianized& gaussianized, int bits) {
  Table table;
  table.format = formatOf(gaussianized.dimensions, bits);
  table.width = std::uint32_t(gaussianized.width);
  table.height = std::uint32_t(gaussianized.height);
  const int channels = channelCount(table.format);
  exemplar::ImageLevel level{gaussianized.width, gaussianized.height, channels, {}};
  level.values.reserve(gaussianized.image.size() * std::size_t(channels));
  for (const Point& p : gaussianized.image) {
    constexpr float kShift = kStoredGaussianMean - float(gaussian::kGaussianMean);
    const std::array<float, 4> texel{p.x + kShift, p.y + kShift, p.z + kShift, 0.0f};
    level.values.insert(level.values.end(), texel.begin(), texel.begin() + channels);
  }
  appendTexels(table.texels, table.format, level.values);
  while (level.width > 1 || level.height > 1) {
    level = exemplar::areaAverage(level);
    appendTexels(table.texels, table.format, level.values);
    ++table.mipLevels;
  }
  setLoss(table, fetchLoss(table, gaussianized.dimensions));
  return table;
}

std::vector<exemplar::ChannelMatrix> lostVariance(const Table& gaussian, int channels) {
  const int stride = channelCount(gaussian.format);
  const exemplar::ChannelMatrix full = covarianceOf(decodeLevel(gaussian, 0), stride, channels);
  const double variance = full.trace() / double(channels);
  std::vector<exemplar::ChannelMatrix> lost(gaussian.mipLevels,
                                            exemplar::ChannelMatrix::Zero(channels, channels));
  for (std::uint32_t mip = 1; mip < gaussian.mipLevels && variance > kNoVariance; ++mip)
    lost[mip] = (full - covarianceOf(decodeLevel(gaussian, mip), stride, channels)) / variance;
  return lost;
}

double scalarLoss(const exemplar::ChannelMatrix& loss) {
  return std::clamp(loss.trace() / double(loss.rows()), 0.0, 1.0);
}

// Mip levels (height, width, channels) -> variances and covariances of bilinear fetches, averaged
// over all positions -> the losses that interpolate best between mip levels.
namespace {

/// Positions at which two mip levels are fetched together. The ratio of their covariance to the
/// variance of the coarser one, whose deviation is about 1/2, has a standard error of 0.003 or
/// less.
constexpr std::uint32_t kPositions = 1u << 15u;

struct Level {
  std::size_t width, height;
  const std::vector<std::array<float, 4>>& texels;
};

/// Mean over texels and channels of the product of a texel and one further on, both less 1/2.
double lagProduct(const Level& level, int dimensions, std::size_t right, std::size_t down) {
  const auto rows = [&](const tbb::blocked_range<std::size_t>& range, double sum) {
    for (std::size_t y = range.begin(); y < range.end(); ++y) {
      const std::array<float, 4>* row = &level.texels[y * level.width];
      const std::array<float, 4>* other = &level.texels[(y + down) % level.height * level.width];
      for (std::size_t x = 0; x < level.width; ++x)
        for (std::size_t c = 0; c < std::size_t(dimensions); ++c)
          sum += (double(row[x][c]) - double(kStoredGaussianMean)) *
                 (double(other[(x + right) % level.width][c]) - double(kStoredGaussianMean));
    }
    return sum;
  };
  const double sum = tbb::parallel_deterministic_reduce(
      tbb::blocked_range<std::size_t>(0, level.height, 64), 0.0, rows, std::plus<>());
  return sum / double(level.texels.size() * std::size_t(dimensions));
}

/// The variance of bilinear fetches, averaged over all positions.
double fetchVariance(const Level& level, int dimensions) {
  // Weights 1 - f and f, f uniform: E[(1 - f)^2 + f^2] = 2/3 of the texel's own variance along an
  // axis, E[2 f (1 - f)] = 1/3 of the product with its neighbour.
  const double own = lagProduct(level, dimensions, 0, 0);
  const double right = lagProduct(level, dimensions, 1, 0);
  const double down = lagProduct(level, dimensions, 0, 1);
  const double diagonal = 0.5 * (lagProduct(level, dimensions, 1, 1) +
                                 lagProduct(level, dimensions, level.width - 1, 1));
  return (4.0 * own + 2.0 * right + 2.0 * down + diagonal) / 9.0;
}

/// Covariance of fetches of a mip level and the next, over the variance of the next one's.
double nextRatio(const RepeatingImage& image, int dimensions, std::uint32_t mip) {
  double product = 0.0, square = 0.0;
  for (std::uint32_t k = 0; k < kPositions; ++k) {
    const std::array<float, 2> at = spreadPosition(k, kPositions);
    const std::array<float, 4> fine = image.at(at[0], at[1], float(mip));
    const std::array<float, 4> coarse = image.at(at[0], at[1], float(mip + 1));
    for (std::size_t c = 0; c < std::size_t(dimensions); ++c) {
      const double next = double(coarse[c]) - double(kStoredGaussianMean);
      product += (double(fine[c]) - double(kStoredGaussianMean)) * next;
      square += next * next;
    }
  }
  return square > 0.0 ? product / square : 0.0;
}

} // namespace

std::vector<double> fetchLoss(const Table& gaussian, int dimensions) {
  const RepeatingImage image(gaussian);
  std::vector<double> variance;
  for (std::uint32_t mip = 0; mip < gaussian.mipLevels; ++mip) {
    const Level level{std::max(1u, gaussian.width >> mip), std::max(1u, gaussian.height >> mip),
                      image.texels(mip)};
    if (mip == 0) {
      const double whole = lagProduct(level, dimensions, 0, 0);
      if (whole < kNoVariance)
        return std::vector<double>(gaussian.mipLevels, 0.0);
      variance.push_back(whole);
    }
    variance.push_back(fetchVariance(level, dimensions));
  }
  const double whole = variance.front();
  variance.erase(variance.begin());
  for (double& v : variance)
    v /= whole;
  // A fetch at level m + t keeps (1 - t)^2 V_m + 2 t (1 - t) C_m + t^2 V_(m+1). Least squares over
  // t for the values at whole levels, of which the first is given.
  const auto count = Eigen::Index(variance.size());
  std::vector<double> ratios(variance.size() - 1);
  tbb::parallel_for(std::size_t(0), ratios.size(), [&](std::size_t m) {
    ratios[m] = nextRatio(image, dimensions, std::uint32_t(m));
  });
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(count, count);
  Eigen::VectorXd target = Eigen::VectorXd::Zero(count);
  for (Eigen::Index m = 0; m + 1 < count; ++m) {
    const double fine = variance[std::size_t(m)], coarse = variance[std::size_t(m) + 1];
    const double both = coarse * ratios[std::size_t(m)];
    mass(m, m) += 1.0 / 3.0;
    mass(m + 1, m + 1) += 1.0 / 3.0;
    mass(m, m + 1) += 1.0 / 6.0;
    mass(m + 1, m) += 1.0 / 6.0;
    target[m] += 0.5 - (fine / 4.0 + both / 6.0 + coarse / 12.0);
    target[m + 1] += 0.5 - (fine / 12.0 + both / 6.0 + coarse / 4.0);
  }
  mass.row(0).setZero();
  mass(0, 0) = 1.0;
  target[0] = 1.0 - variance.front();
  const Eigen::VectorXd solved = mass.partialPivLu().solve(target);
  std::vector<double> losses;
  double least = 0.0;
  for (Eigen::Index m = 0; m < count; ++m)
    losses.push_back(least = std::clamp(solved[m], least, 1.0));
  return losses;
}

} // namespace lichen::gaussian
