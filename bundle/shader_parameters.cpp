// SPDX-License-Identifier: MIT
// Bundle and material -> the shader library's uniform structs.
#include <lichen/shader_parameters.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lichen {
namespace {

/// Mean of the decoded values: the last slab of the inverse table, which is constant.
shader::vec4 decodedMean(const Bundle& bundle, const NoiseMap& map) {
  std::array<float, 4> mean{0.0f, 0.0f, 0.0f, 1.0f};
  if (map.inverseTable) {
    const Table& table = bundle.tables[*map.inverseTable];
    const std::vector<float> texels = decodeLevel(table, 0);
    const auto channels = std::size_t(channelCount(table.format));
    std::copy_n(texels.end() - std::ptrdiff_t(channels), std::min<std::size_t>(channels, 3),
                mean.begin());
  } else {
    for (std::size_t c = 0; c < map.mean.size(); ++c)
      mean[c] = float(map.mean[c]);
  }
  return {mean[0], mean[1], mean[2], mean[3]};
}

} // namespace

shader::LichenMap shaderMap(const Bundle& bundle, const Noise& noise, std::size_t mapIndex) {
  const NoiseMap& map = noise.maps[mapIndex];
  const Table& gaussian = bundle.tables[map.gaussian];
  shader::LichenMap result{};
  result.widthTexels = float(gaussian.width);
  result.heightTexels = float(gaussian.height);
  result.dimensions = shader::uint(std::min(3, channelCount(gaussian.format)));
  result.mipCount = std::min<shader::uint>(gaussian.mipLevels, LICHEN_MAX_MIPS);
  result.bilinearLossX = float(map.bilinearLoss[0]);
  result.bilinearLossY = float(map.bilinearLoss[1]);
  result.tableLevels = shader::uint(map.levels.size());
  result.mean = decodedMean(bundle, map);
  std::array<float, LICHEN_MAX_MIPS> loss{};
  for (std::size_t mip = 0; mip < loss.size() && !map.mipLoss.empty(); ++mip)
    loss[mip] = float(map.mipLoss[std::min(mip, map.mipLoss.size() - 1)]);
  for (std::size_t k = 0; k < 4; ++k)
    result.mipLoss[k] = {loss[4 * k], loss[4 * k + 1], loss[4 * k + 2], loss[4 * k + 3]};
  return result;
}

shader::LichenNoise shaderNoise(const Bundle& bundle, const MaterialNoise& material,
                                const Placement& placement) {
  const Noise& noise = bundle.noises[material.noise];
  shader::LichenNoise result{};
  const double cosine = std::cos(material.rotation) / material.scale;
  const double sine = std::sin(material.rotation) / material.scale;
  result.uvToTileXX = float(cosine);
  result.uvToTileXY = float(sine);
  result.uvToTileYX = float(-sine);
  result.uvToTileYY = float(cosine);
  result.offsetX = float(material.offset[0]);
  result.offsetY = float(material.offset[1]);
  result.blendSharpness = float(material.blendSharpness);
  result.contrast = float(material.contrast);

  const Lattice lattice = placement.periodic
                              ? periodicLattice(placement.periodTilesX, placement.periodTilesY)
                              : Lattice{};
  result.columnsPerTile = float(lattice.columnsPerTile);
  result.rowsPerTile = float(lattice.rowsPerTile);
  result.periodColumns = lattice.periodColumns;
  result.periodRows = lattice.periodRows;
  result.periodTilesX = float(placement.periodTilesX);
  result.periodTilesY = float(placement.periodTilesY);
  const LatticeOrigin origin = placement.periodic
                                   ? LatticeOrigin{}
                                   : latticeOrigin(placement.tileOriginX, placement.tileOriginY);
  result.cellI = origin.cell[0];
  result.cellJ = origin.cell[1];
  result.fractionI = origin.fraction[0];
  result.fractionJ = origin.fraction[1];

  result.maxAnisotropy = float(std::max(1.0, placement.maxAnisotropy));
  result.tileSizeMetres = float(noise.tileSizeMetres);
  result.seedWord = latticeSeed(material.seed, 0);
  result.seed = material.seed;
  for (const NoiseMap& map : noise.maps) {
    const Table& gaussian = bundle.tables[map.gaussian];
    result.tileWidthTexels = std::max(result.tileWidthTexels, gaussian.width);
    result.tileHeightTexels = std::max(result.tileHeightTexels, gaussian.height);
  }
  return result;
}

} // namespace lichen
