// SPDX-License-Identifier: MIT
// A map's image, matrix and lost variances -> members of its constants.
#include "map_constants.h"

#include <lichen/lattice.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lichen {
namespace {

/// Six times the lower Cholesky factor of a positive definite n x n matrix, row-major. It maps
/// Gaussian values of standard deviation 1/6 to values with this covariance.
std::vector<double> gaussianToStored(const std::vector<double>& covariance, std::size_t n) {
  constexpr double kDeviations = 6.0;
  std::vector<double> factor(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      double rest = covariance[i * n + j];
      for (std::size_t k = 0; k < j; ++k)
        rest -= factor[i * n + k] * factor[j * n + k];
      factor[i * n + j] = i == j ? std::sqrt(std::max(0.0, rest)) : rest / factor[j * n + j];
    }
  for (double& value : factor)
    value *= kDeviations;
  return factor;
}

/// The mean of the decoded value for a stored value that is Gaussian about `stored`.
float meanDecoded(float stored, float variance, shader::uint encoding) {
  constexpr float kHalfLn2 = float(0.5 * std::numbers::ln2);
  constexpr float kMostLog = 16.0f; // kHalfMax is below 2^16 - 1
  switch (encoding) {
  case LICHEN_ENCODING_SLOPE:
    return stored;
  case LICHEN_ENCODING_LINEAR:
    return std::clamp(stored, 0.0f, 1.0f);
  case LICHEN_ENCODING_LOG2:
    return std::max(std::exp2(std::min(stored + kHalfLn2 * variance, kMostLog)) - 1.0f, 0.0f);
  default:
    return stored * stored + variance;
  }
}

/// Sets the mean of the decoded values of a map with a table.
void setTableMean(const NoiseMap& map, const Table& table, shader::LichenMap& constants) {
  const std::size_t n = map.mean.size();
  std::array<float, 4> mean{0.0f, 0.0f, 0.0f, 1.0f};
  double variance = 0.0;
  for (std::size_t c = 0; c < n; ++c) {
    const double own = map.covariance[c * n + c];
    variance += own / double(n);
    // The mean of a square is the square of the mean, and the variance.
    mean[c] =
        float(map.encoding == ValueEncoding::root ? map.mean[c] * map.mean[c] + own : map.mean[c]);
  }
  if (map.encoding == ValueEncoding::slope)
    mean[2] = float(variance);
  if (map.encoding == ValueEncoding::log2) {
    // The mean of light, which only the table knows: all cells are equally likely.
    const std::vector<float> cells = decodeLevel(table, 0);
    const auto channels = std::size_t(channelCount(table.format));
    for (std::size_t c = 0; c < n; ++c) {
      double sum = 0.0;
      for (std::size_t i = c; i < cells.size(); i += channels)
        sum += double(cells[i]);
      mean[c] = float(sum * double(channels) / double(cells.size()));
    }
  }
  constants.mean = {mean[0], mean[1], mean[2], mean[3]};
}

} // namespace

void setImage(shader::LichenMap& constants, const Table& image) {
  constants.dimensions = shader::uint(std::min(3, channelCount(image.format)));
  constants.mipCount = std::min<shader::uint>(image.mipLevels, LICHEN_MAX_MIPS);
}

float levelOffset(const Table& image, const std::array<std::uint32_t, 2>& tile) {
  const double texels = double(image.width) * image.height;
  return float(0.5 * std::log2(texels / (double(tile[0]) * tile[1])));
}

void setOffsetSteps(shader::LichenNoise& constants) {
  const auto step = [](float side) {
    return float(double(1u << tileOffsetShift(std::uint32_t(side))) / double(side));
  };
  constants.offsetStepX = step(constants.tileTexelsX);
  constants.offsetStepY = step(constants.tileTexelsY);
}

void setRows(shader::LichenMap& constants, const std::vector<double>& matrix,
             std::size_t dimensions, const std::vector<double>& offset) {
  const std::array<shader::vec4*, 3> rows{&constants.row0, &constants.row1, &constants.row2};
  for (std::size_t c = 0; c < offset.size(); ++c) {
    std::array<float, 3> row{};
    for (std::size_t d = 0; d < dimensions; ++d)
      row[d] = float(matrix[c * dimensions + d]);
    *rows[c] = {row[0], row[1], row[2], float(offset[c])};
  }
}

void setLinearRows(shader::LichenMap& constants, const NoiseMap& map, const Table& table) {
  const std::size_t n = map.mean.size();
  const std::vector<float> cells = decodeLevel(table, 0);
  const auto channels = std::size_t(channelCount(table.format));
  const std::array<std::size_t, 3> sides{table.width, table.height, std::max(1u, table.depth)};
  std::vector<double> rows(3 * n, 0.0);
  for (std::size_t i = 0; i < cells.size() / channels; ++i) {
    const std::array<std::size_t, 3> at{i % sides[0], i / sides[0] % sides[1],
                                        i / (sides[0] * sides[1])};
    for (std::size_t c = 0; c < n; ++c)
      for (std::size_t d = 0; d < 3; ++d)
        rows[3 * c + d] +=
            double(cells[channels * i + c]) * ((double(at[d]) + 0.5) / double(sides[d]) - 0.5);
  }
  for (std::size_t c = 0; c < n; ++c) {
    double square = 0.0;
    for (std::size_t d = 0; d < 3; ++d)
      square += rows[3 * c + d] * rows[3 * c + d];
    constexpr double kDeviations = 6.0; // as gaussianToStored()
    for (std::size_t d = 0; square > 0.0 && d < 3; ++d)
      rows[3 * c + d] *= kDeviations * std::sqrt(map.covariance[c * n + c] / square);
  }
  setRows(constants, rows, 3, map.mean);
}

shader::uvec4 retainedAmplitudes(std::span<const double> losses) {
  std::array<shader::uint, 4> words{};
  for (std::size_t mip = 0; mip < LICHEN_MAX_MIPS && !losses.empty(); ++mip) {
    const double loss = losses[std::min(mip, losses.size() - 1)];
    words[mip / 4] |= shader::uint(std::lround(255.0 * std::sqrt(1.0 - loss))) << (8 * (mip % 4));
  }
  return {words[0], words[1], words[2], words[3]};
}

void setGaussianMean(shader::LichenMap& constants) {
  // As lichenDecodeGaussian (shaders_glsl/noise/decode.glsl) where all variance is lost.
  std::array<float, 3> mean{}, variance{};
  const std::array<const shader::vec4*, 3> rows{&constants.row0, &constants.row1, &constants.row2};
  for (std::size_t c = 0; c < 3; ++c) {
    const shader::vec4& row = *rows[c];
    constexpr float kVariance = 1.0f / 36.0f; // of a Gaussian value: rows are six times the root
    variance[c] = kVariance * (row.x * row.x + row.y * row.y + row.z * row.z);
    mean[c] = meanDecoded(row.w, variance[c], constants.encoding);
  }
  if (constants.encoding == LICHEN_ENCODING_SLOPE)
    mean[2] = 0.5f * (variance[0] + variance[1]);
  constants.mean = {mean[0], mean[1], mean[2], 1.0f};
}

void setDecoding(shader::LichenMap& constants, const Bundle& bundle, const NoiseMap& map,
                 std::optional<std::size_t> inverseTable) {
  if (inverseTable)
    return setTableMean(map, bundle.tables[*inverseTable], constants);
  const std::size_t n = map.mean.size();
  constants.decoding = LICHEN_DECODING_GAUSSIAN;
  setRows(constants, gaussianToStored(map.covariance, n), n, map.mean);
  setGaussianMean(constants);
}

} // namespace lichen
