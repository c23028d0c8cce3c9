// SPDX-License-Identifier: MIT
// Gaussian image (width * height points) -> mip chain -> lost covariance of each mip level.
#include "mip_chain.h"

#include "exemplar/area_average.h"
#include "fetch_loss.h"

#include <algorithm>
#include <cmath>

namespace lichen::gaussianization {
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

} // namespace lichen::gaussianization
