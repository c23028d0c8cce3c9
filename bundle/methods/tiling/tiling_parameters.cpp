// SPDX-License-Identifier: MIT
// A tiling noise and its material -> the tiling-only members of the shader's constants.
#include "methods/map_constants.h"
#include "methods/method_part.h"
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

/// Sets the mean of the decoded values of a map with a table.
void setTableMean(const NoiseMap& map, const Bundle& bundle, shader::LichenMap& constants) {
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
    // Of light, which only the table knows: all cells are equally likely.
    const Table& table = bundle.tables[*map.as<TilingMap>().inverseTable];
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

/// The step between neighbouring tile offsets. [tiles]
float offsetStep(std::uint32_t sizeTexels) {
  return float(double(1u << tileOffsetShift(sizeTexels)) / double(sizeTexels));
}

} // namespace

Lattice TilingFormat::cells(const shader::LichenNoise&, const MaterialNoise&,
                            const Placement& placement) const {
  return placement.periodic ? periodicLattice(placement.periodTilesX, placement.periodTilesY)
                            : Lattice{};
}

std::array<std::int32_t, 2> TilingFormat::cellOf(const Lattice&, std::int64_t tileX,
                                                 std::int64_t tileY) const {
  return latticeCell(tileX, tileY);
}

void TilingFormat::setMap(const Bundle& bundle, const Noise& noise, const NoiseMap& map,
                          shader::LichenMap& constants) const {
  const auto& tiling = map.as<TilingMap>();
  const Table& image = bundle.tables[tiling.gaussian];
  setImage(constants, image);
  constants.dimensions = shader::uint(tiling.dimensions);
  const auto [width, height] = tileSize(bundle, noise);
  // 0 for images of the tile's size alone: others do not share their texels.
  constants.levelOffset =
      float(0.5 * std::log2(double(image.width) * image.height / (double(width) * double(height))));
  constants.interpolationLoss = fetchLosses(image).front();
  if (tableKindOf(tiling) == TableKind::none) {
    const std::size_t n = map.mean.size();
    constants.decoding = LICHEN_DECODING_GAUSSIAN;
    setRows(constants, gaussianToStored(map.covariance, n), n, map.mean);
    return setGaussianMean(constants);
  }
  setTableMean(map, bundle, constants);
}

void TilingFormat::setNoise(const Noise&, shader::LichenNoise& constants) const {
  constants.offsetStepX = offsetStep(std::uint32_t(constants.tileTexelsX));
  constants.offsetStepY = offsetStep(std::uint32_t(constants.tileTexelsY));
}

void TilingFormat::setMaterial(const shader::LichenNoise&, const MaterialNoise& material,
                               const Placement&, shader::LichenMaterial& constants) const {
  setPart(constants,
          shader::LichenTilingMaterial{float(material.blendSharpness), material.tileRotation});
}

shader::LichenTilingMaterial tilingPart(const shader::LichenMaterial& material) {
  return partOf<shader::LichenTilingMaterial>(material);
}

void setPart(shader::LichenMaterial& material, const shader::LichenTilingMaterial& part) {
  setPartOf(material, part);
}

} // namespace lichen
