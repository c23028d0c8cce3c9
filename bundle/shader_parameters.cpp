// SPDX-License-Identifier: MIT
// Bundle and material -> the shader library's uniform structs.
#include <lichen/shader_parameters.h>

#include <algorithm>
#include <array>
#include <bit>
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

/// Size of the largest map of a noise: tile offsets are whole texels of it.
std::array<std::uint32_t, 2> tileTexels(const Noise& noise, const Bundle& bundle) {
  std::array<std::uint32_t, 2> size{1, 1};
  for (const NoiseMap& map : noise.maps) {
    const Table& gaussian = bundle.tables[map.gaussian];
    size = {std::max(size[0], gaussian.width), std::max(size[1], gaussian.height)};
  }
  return size;
}

/// How many of a map's first mips have texels that divide the step between tile offsets.
shader::uint alignedMips(const Noise& noise, const Bundle& bundle, const Table& gaussian) {
  const std::array<std::uint32_t, 2> tile = tileTexels(noise, bundle);
  if (tile != std::array<std::uint32_t, 2>{gaussian.width, gaussian.height})
    return 0;
  const std::uint32_t step = std::min(tileOffsetShift(tile[0]), tileOffsetShift(tile[1]));
  const int halvings = std::min(std::countr_zero(tile[0]), std::countr_zero(tile[1]));
  return 1 + std::min(step, std::uint32_t(halvings));
}

/// sqrt(1 - loss) of each mip as unorm bytes, the first in the lowest byte of x; the last repeats.
shader::uvec4 keptAmplitudes(const std::vector<double>& mipLoss) {
  std::array<shader::uint, 4> words{};
  for (std::size_t mip = 0; mip < LICHEN_MAX_MIPS && !mipLoss.empty(); ++mip) {
    const double loss = mipLoss[std::min(mip, mipLoss.size() - 1)];
    words[mip / 4] |= shader::uint(std::lround(255.0 * std::sqrt(1.0 - loss))) << (8 * (mip % 4));
  }
  return {words[0], words[1], words[2], words[3]};
}

/// The whole tiles of an offset, or on a periodic lattice its whole periods, in tiles.
double wholePart(double offset, bool periodic, double periodTiles) {
  return periodic ? std::floor(offset / periodTiles) * periodTiles : std::floor(offset);
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
  result.alignedMips = alignedMips(noise, bundle, gaussian);
  result.tableLevels = shader::uint(map.levels.size());
  result.mean = decodedMean(bundle, map);
  result.mipKept = keptAmplitudes(map.mipLoss);
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
  // Whole tiles or periods of the offset go where they are exact, so that floats hold the rest.
  const double wholeX = wholePart(material.offset[0], placement.periodic, placement.periodTilesX);
  const double wholeY = wholePart(material.offset[1], placement.periodic, placement.periodTilesY);
  result.offsetX = float(material.offset[0] - wholeX);
  result.offsetY = float(material.offset[1] - wholeY);
  const LatticeOrigin origin = placement.periodic
                                   ? LatticeOrigin{}
                                   : latticeOrigin(placement.tileOriginX + std::int64_t(wholeX),
                                                   placement.tileOriginY + std::int64_t(wholeY));
  result.cellI = origin.cell[0];
  result.cellJ = origin.cell[1];
  result.fractionI = origin.fraction[0];
  result.fractionJ = origin.fraction[1];

  result.maxAnisotropy = float(std::max(1.0, placement.maxAnisotropy));
  result.tileSizeMetres = float(noise.tileSizeMetres);
  result.seedWord = latticeSeed(material.seed, 0);
  result.seed = material.seed;
  const std::array<std::uint32_t, 2> tile = tileTexels(noise, bundle);
  const auto step = [](std::uint32_t size) {
    return float(double(1u << tileOffsetShift(size)) / double(size));
  };
  result.offsetCountX = tile[0] >> tileOffsetShift(tile[0]);
  result.offsetCountY = tile[1] >> tileOffsetShift(tile[1]);
  result.offsetStepX = step(tile[0]);
  result.offsetStepY = step(tile[1]);
  return result;
}

} // namespace lichen
