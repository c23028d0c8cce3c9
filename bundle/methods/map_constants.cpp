// SPDX-License-Identifier: MIT
// A map's image, matrix and lost variances -> members of its constants.
#include "map_constants.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lichen {

void setImage(shader::LichenMap& constants, const Table& image) {
  constants.dimensions = shader::uint(std::min(3, channelCount(image.format)));
  constants.mipCount = std::min<shader::uint>(image.mipLevels, LICHEN_MAX_MIPS);
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

shader::uvec4 retainedAmplitudes(std::span<const double> losses) {
  std::array<shader::uint, 4> words{};
  for (std::size_t mip = 0; mip < LICHEN_MAX_MIPS && !losses.empty(); ++mip) {
    const double loss = losses[std::min(mip, losses.size() - 1)];
    words[mip / 4] |= shader::uint(std::lround(255.0 * std::sqrt(1.0 - loss))) << (8 * (mip % 4));
  }
  return {words[0], words[1], words[2], words[3]};
}

void setGaussianMean(shader::LichenMap& constants) {
  const std::array<float, 4> mean =
      decodedGaussian(constants, {0.5f, 0.5f, 0.5f}, {1.0f, 1.0f, 1.0f});
  constants.mean = {mean[0], mean[1], mean[2], mean[3]};
}

} // namespace lichen
