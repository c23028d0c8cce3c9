// SPDX-License-Identifier: MIT
// A tiling noise and its material -> the tiling-only members of the shader's constants.
#include "methods/map_constants.h"
#include "tiling_format.h"

#include <algorithm>
#include <bit>
#include <cmath>

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

/// Sets the mean of the decoded values, from the last slab of the inverse table, which is constant.
void setTableMean(const TilingMap& map, const Bundle& bundle, shader::LichenMap& constants) {
  const Table& table = bundle.tables[*map.inverseTable];
  const std::vector<float> texels = decodeLevel(table, 0);
  const auto channels = std::size_t(channelCount(table.format));
  std::array<float, 4> mean{0.0f, 0.0f, 0.0f, 1.0f};
  std::copy_n(texels.end() - std::ptrdiff_t(channels), std::min<std::size_t>(channels, 3),
              mean.begin());
  constants.mean = {mean[0], mean[1], mean[2], mean[3]};
}

/// The number of mip levels, from level 0, whose texel size divides the step between tile offsets.
/// 0 if the map's size differs from the tile's.
shader::uint alignedMips(const std::array<std::uint32_t, 2>& tile, const Table& gaussian) {
  if (tile != std::array<std::uint32_t, 2>{gaussian.width, gaussian.height})
    return 0;
  const std::uint32_t step = std::min(tileOffsetShift(tile[0]), tileOffsetShift(tile[1]));
  const int halvings = std::min(std::countr_zero(tile[0]), std::countr_zero(tile[1]));
  return 1 + std::min(step, std::uint32_t(halvings));
}

/// Sets the number of tile offsets and the step between them.
void setTileOffsets(shader::LichenNoise& result, const std::array<std::uint32_t, 2>& tile) {
  const auto step = [](std::uint32_t size) {
    return float(double(1u << tileOffsetShift(size)) / double(size));
  };
  result.offsetCountX = tile[0] >> tileOffsetShift(tile[0]);
  result.offsetCountY = tile[1] >> tileOffsetShift(tile[1]);
  result.offsetStepX = step(tile[0]);
  result.offsetStepY = step(tile[1]);
}

} // namespace

Lattice TilingFormat::cells(const Noise&, const MaterialNoise&, const Placement& placement) const {
  return placement.periodic ? periodicLattice(placement.periodTilesX, placement.periodTilesY)
                            : Lattice{};
}

LatticeOrigin TilingFormat::cellOf(const Lattice&, std::int64_t tileX, std::int64_t tileY) const {
  return latticeOrigin(tileX, tileY);
}

void TilingFormat::setMap(const Bundle& bundle, const Noise& noise, const NoiseMap& map,
                          shader::LichenMap& constants) const {
  const auto& tiling = map.as<TilingMap>();
  const Table& image = bundle.tables[tiling.gaussian];
  setImage(constants, image);
  constants.mipKept0 = keptAmplitudes(tiling.mipLoss);
  constants.alignedMips = alignedMips(tileSize(bundle, noise), image);
  constants.tableLevels = shader::uint(tiling.levels.size());
  if (tableKindOf(tiling) == TableKind::none) {
    const std::size_t n = map.mean.size();
    constants.decoding = LICHEN_DECODING_GAUSSIAN;
    setRows(constants, gaussianToStored(map.covariance, n), n, map.mean);
    return setGaussianMean(constants);
  }
  setTableMean(tiling, bundle, constants);
}

void TilingFormat::setNoise(const Bundle& bundle, const MaterialNoise& material, const Placement&,
                            shader::LichenNoise& constants) const {
  const std::array<std::uint32_t, 2> tile = tileSize(bundle, bundle.noises[material.noise]);
  setTileOffsets(constants, tile);
  constants.tileAspect = float(double(tile[0]) / double(tile[1]));
  constants.tileRotation = material.tileRotation;
}

} // namespace lichen
