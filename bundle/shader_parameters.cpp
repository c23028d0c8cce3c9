// SPDX-License-Identifier: MIT
// Bundle and material -> the shader library's uniform structs.
#include "impact_grid.h"

#include <lichen/shader_parameters.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>

namespace lichen {
namespace {

/// Rows of an n x d matrix (row-major) and an offset, as the shader takes them; what is absent is
/// 0.
void setRows(shader::LichenMap& map, const std::vector<double>& matrix, std::size_t dimensions,
             const std::vector<double>& offset) {
  const std::array<shader::vec4*, 3> rows{&map.row0, &map.row1, &map.row2};
  for (std::size_t c = 0; c < offset.size(); ++c) {
    std::array<float, 3> row{};
    for (std::size_t d = 0; d < dimensions; ++d)
      row[d] = float(matrix[c * dimensions + d]);
    *rows[c] = {row[0], row[1], row[2], float(offset[c])};
  }
}

/// Six times the lower Cholesky factor of a positive definite n x n matrix, row by row: what takes
/// Gaussian values of deviation 1/6 to this covariance.
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

/// The n x n matrix with these values on its diagonal, row by row.
std::vector<double> diagonal(const std::vector<double>& values) {
  const std::size_t n = values.size();
  std::vector<double> matrix(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i)
    matrix[i * n + i] = values[i];
  return matrix;
}

float dotRow(const shader::vec4& row, const std::array<float, 3>& v) {
  return row.x * v[0] + row.y * v[1] + row.z * v[2];
}

shader::uint encodingOf(ValueEncoding encoding) {
  switch (encoding) {
  case ValueEncoding::srgb:
    return LICHEN_ENCODING_SRGB;
  case ValueEncoding::linear:
    return LICHEN_ENCODING_LINEAR;
  case ValueEncoding::slope:
    return LICHEN_ENCODING_SLOPE;
  case ValueEncoding::log2:
    return LICHEN_ENCODING_LOG2;
  }
  return LICHEN_ENCODING_SRGB;
}

/// Mean of the decoded values: of the last slab of the inverse table, which is constant.
std::array<float, 4> decodedMean(const shader::LichenMap& constants, const Bundle& bundle,
                                 const NoiseMap& map) {
  if (!map.inverseTable)
    return decodedGaussian(constants, {0.5f, 0.5f, 0.5f}, {1.0f, 1.0f, 1.0f});
  const Table& table = bundle.tables[*map.inverseTable];
  const std::vector<float> texels = decodeLevel(table, 0);
  const auto channels = std::size_t(channelCount(table.format));
  std::array<float, 4> mean{0.0f, 0.0f, 0.0f, 1.0f};
  std::copy_n(texels.end() - std::ptrdiff_t(channels), std::min<std::size_t>(channels, 3),
              mean.begin());
  if (tableKindOf(map) == TableKind::joint)
    return mean;
  return decodedSeparable(constants, {mean[0], mean[1], mean[2]});
}

/// Size of the largest map of a noise: tile offsets are whole texels of it.
std::array<std::uint32_t, 2> tileTexels(const Noise& noise, const Bundle& bundle) {
  std::array<std::uint32_t, 2> size{1, 1};
  for (const NoiseMap& map : noise.maps) {
    const Table& gaussian = bundle.tables[map.image];
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
shader::uvec4 keptAmplitudes(std::span<const double> losses) {
  std::array<shader::uint, 4> words{};
  for (std::size_t mip = 0; mip < LICHEN_MAX_MIPS && !losses.empty(); ++mip) {
    const double loss = losses[std::min(mip, losses.size() - 1)];
    words[mip / 4] |= shader::uint(std::lround(255.0 * std::sqrt(1.0 - loss))) << (8 * (mip % 4));
  }
  return {words[0], words[1], words[2], words[3]};
}

/// What mips keep of each channel of a texton; nothing of one that does not vary, so that impacts
/// are left out where nothing is left of the others.
void setTextonKept(shader::LichenMap& result, const NoiseMap& map) {
  const std::array<shader::uvec4*, 3> kept{&result.mipKept0, &result.mipKept1, &result.mipKept2};
  for (std::size_t c = 0; c < map.scale.size(); ++c)
    if (map.scale[c] > 0.0)
      *kept[c] = keptAmplitudes(lossRow(map.mipLoss, c, map.scale.size()));
}

/// The whole tiles of an offset, or on a periodic lattice its whole periods, in tiles.
double wholePart(double offset, bool periodic, double periodTiles) {
  return periodic ? std::floor(offset / periodTiles) * periodTiles : std::floor(offset);
}

/// The remainder of a tile origin in [0, period), a whole period where the origin is not 0.
double reduced(std::int64_t origin, double period) {
  if (origin == 0)
    return 0.0;
  const auto whole = std::int64_t(period);
  return double(((origin % whole) + whole) % whole);
}

/// Where a tile origin lies in a periodic lattice.
LatticeOrigin periodicOrigin(const Lattice& lattice, bool isSkewed, const Placement& placement) {
  const double row = reduced(placement.tileOriginY, placement.periodTilesY) * lattice.rowsPerTile;
  const double column =
      reduced(placement.tileOriginX, placement.periodTilesX) * lattice.columnsPerTile -
      (isSkewed ? 0.5 * row : 0.0);
  const float belowOne = std::nextafter(1.0f, 0.0f); // cells are half-open
  return {{int(std::floor(column)), int(std::floor(row))},
          {std::min(float(column - std::floor(column)), belowOne),
           std::min(float(row - std::floor(row)), belowOne)}};
}

/// The cubes of impacts, and the one at the place's origin. A texture's offset has no meaning in
/// space.
void setCubes(shader::LichenNoise& result, const Noise& noise, const MaterialNoise& material,
              const Placement& placement) {
  const Lattice grid = surfaceGrid(noise.texton, material.impacts);
  result.columnsPerTile = result.rowsPerTile = float(grid.columnsPerTile);
  const LatticeOrigin across = impactGridOrigin(grid, placement.tileOriginX, placement.tileOriginY);
  const LatticeOrigin along = impactGridOrigin(grid, placement.tileOriginZ, 0);
  result.cellI = across.cell[0];
  result.cellJ = across.cell[1];
  result.cellK = along.cell[0];
  result.seedWord = latticeSeed(material.seed, kSurfacePlane);
}

/// The lattice of tiling or the grid of impacts, and where the place's origin lies in it.
void setCells(shader::LichenNoise& result, const Noise& noise, const MaterialNoise& material,
              const Placement& placement) {
  const bool isTiling = noise.method == Method::tiling;
  const Lattice lattice = !isTiling ? impactGrid(noise.texton, material.impacts, placement)
                          : placement.periodic
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
  const std::int64_t tileX = placement.tileOriginX + std::int64_t(wholeX);
  const std::int64_t tileY = placement.tileOriginY + std::int64_t(wholeY);
  const LatticeOrigin origin = placement.periodic ? periodicOrigin(lattice, isTiling, placement)
                               : isTiling         ? latticeOrigin(tileX, tileY)
                                                  : impactGridOrigin(lattice, tileX, tileY);
  result.cellI = origin.cell[0];
  result.cellJ = origin.cell[1];
  result.fractionI = origin.fraction[0];
  result.fractionJ = origin.fraction[1];
}

/// An origin in space, in tiles -> along the right and down of the plane that looks along an axis.
std::array<double, 2> ontoPlane(const Placement& placement, std::size_t axis) {
  const auto x = double(placement.tileOriginX);
  const auto y = double(placement.tileOriginY);
  const auto z = double(placement.tileOriginZ);
  const std::array<std::array<double, 2>, 3> planes{{{-z, -y}, {x, z}, {x, -y}}};
  return planes[axis];
}

/// Width over height of a tile, whose texels are square in space.
double tileAspect(const Noise& noise, const Bundle& bundle) {
  if (noise.method == Method::texton)
    return double(noise.texton.texelsPerTileX) / double(noise.texton.texelsPerTileY);
  const std::array<std::uint32_t, 2> tile = tileTexels(noise, bundle);
  return double(tile[0]) / double(tile[1]);
}

/// The three planes of triplanar noise, each at the place's origin. Exact where tiles are square
/// and not rotated; else 2^-12 tiles off at 2^40.
void setPlanes(shader::LichenNoise& result, const Bundle& bundle, const Noise& noise,
               const MaterialNoise& material, const Placement& placement) {
  const bool isTiling = noise.method == Method::tiling;
  const Lattice lattice = isTiling ? Lattice{} : impactGrid(noise.texton, material.impacts, {});
  const double aspect = tileAspect(noise, bundle);
  const double cosine = std::cos(material.rotation);
  const double sine = std::sin(material.rotation);
  result.columnsPerTile = float(lattice.columnsPerTile);
  result.rowsPerTile = float(lattice.rowsPerTile);
  result.planeSharpness = float(material.planeSharpness);
  result.tileAspect = float(aspect);
  const std::array<shader::LichenPlane*, 3> planes{&result.planeX, &result.planeY, &result.planeZ};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [right, down] = ontoPlane(placement, axis);
    const std::array<double, 2> origin{cosine * right + sine * down,
                                       aspect * (cosine * down - sine * right)};
    std::array<std::int64_t, 2> tile{};
    std::array<float, 2> rest{};
    for (std::size_t k = 0; k < 2; ++k) {
      const double offset = origin[k] - std::floor(origin[k]) + material.offset[k];
      tile[k] = std::int64_t(std::floor(origin[k])) + std::int64_t(std::floor(offset));
      rest[k] = float(offset - std::floor(offset));
    }
    const LatticeOrigin at =
        isTiling ? latticeOrigin(tile[0], tile[1]) : impactGridOrigin(lattice, tile[0], tile[1]);
    *planes[axis] = {at.cell[0],
                     at.cell[1],
                     at.fraction[0],
                     at.fraction[1],
                     rest[0],
                     rest[1],
                     latticeSeed(material.seed, std::uint32_t(axis)),
                     0};
  }
}

/// The steps between the offsets of tiles of this size.
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

std::array<float, 4> decodedSeparable(const shader::LichenMap& map,
                                      const std::array<float, 3>& along) {
  const float most = map.encoding == LICHEN_ENCODING_LOG2 ? kHalfMax : 1.0f;
  const auto clamped = [&](const shader::vec4& row) {
    return std::clamp(dotRow(row, along) + row.w, 0.0f, most);
  };
  return {clamped(map.row0), clamped(map.row1), clamped(map.row2), 1.0f};
}

shader::LichenMap shaderMap(const Bundle& bundle, const Noise& noise, std::size_t mapIndex) {
  const NoiseMap& map = noise.maps[mapIndex];
  const Table& image = bundle.tables[map.image];
  shader::LichenMap result{};
  result.widthTexels = float(image.width);
  result.heightTexels = float(image.height);
  result.dimensions = shader::uint(std::min(3, channelCount(image.format)));
  result.mipCount = std::min<shader::uint>(image.mipLevels, LICHEN_MAX_MIPS);
  result.encoding = encodingOf(map.encoding);
  const std::size_t n = map.mean.size();
  if (noise.method == Method::texton) {
    result.decoding = LICHEN_DECODING_GAUSSIAN;
    setRows(result, diagonal(map.scale), n, map.mean);
    result.sumFactor = {1.0f, 1.0f, 1.0f, 0.0f};
    setTextonKept(result, map);
  } else {
    result.mipKept0 = keptAmplitudes(map.mipLoss);
    result.alignedMips = alignedMips(noise, bundle, image);
    result.tableLevels = shader::uint(map.levels.size());
    const TableKind kind = tableKindOf(map);
    if (kind == TableKind::none) {
      result.decoding = LICHEN_DECODING_GAUSSIAN;
      setRows(result, gaussianToStored(map.covariance, n), n, map.mean);
    } else if (kind == TableKind::separable) {
      result.decoding = LICHEN_DECODING_SEPARABLE;
      setRows(result, map.tableBasis, result.dimensions, map.tableOffset);
    }
  }
  const std::array<float, 4> mean = decodedMean(result, bundle, map);
  result.mean = {mean[0], mean[1], mean[2], mean[3]};
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
  result.maxAnisotropy = float(std::max(1.0, placement.maxAnisotropy));
  result.tileSizeMetres = float(noise.tileSizeMetres);
  result.seedWord = latticeSeed(material.seed, 0);
  result.seed = material.seed;
  if (material.mapping == Mapping::surface)
    setCubes(result, noise, material, placement);
  else if (material.mapping == Mapping::triplanar)
    setPlanes(result, bundle, noise, material, placement);
  else
    setCells(result, noise, material, placement);
  if (noise.method == Method::texton)
    result.method = LICHEN_METHOD_TEXTON;
  else {
    setTileOffsets(result, tileTexels(noise, bundle));
    result.tileAspect = float(tileAspect(noise, bundle));
    result.tileRotation = material.tileRotation;
  }
  return result;
}

} // namespace lichen
