// SPDX-License-Identifier: MIT
// Shape of the textons, mean number of impacts -> the grid of cells, and the shader's constants.
// Whole cells in a tile make integer tile origins exact; the amplitude is that of the density that
// results, so the covariance is exact too, and only the number of impacts is rounded. [GLM17]
// Galerne, Leclaire and Moisan 2017, section 6.
#include "impact_grid.h"

#include <algorithm>
#include <cmath>

namespace lichen {
namespace {

/// How many cells come nearest to filling a length: at least one, and so few that an int holds
/// three periods of them.
int cellsIn(double lengthTexels, double sideTexels) {
  constexpr double kMostCells = 1 << 29;
  return int(std::clamp(std::round(lengthTexels / sideTexels), 1.0, kMostCells));
}

/// A B-spline of order k reaches (k + 1) / 2 texels beyond the centres of the coefficients.
double supportArea(const TextonShape& shape) {
  return double(shape.coefficientsX + shape.order) * double(shape.coefficientsY + shape.order);
}

/// The r of [GLM17] section 6, how thick a layer of impacts a point sees; of a texton that is not
/// square, the side of the square of its area.
double surfaceThickness(const TextonShape& shape) { return std::sqrt(supportArea(shape)); }

/// Weight of a mix = constant + perUv . uv.
struct LinearWeight {
  double constant = 0.0;
  std::array<double, 2> perUv{};
};

/// Of a constant or a direction, at texture coordinates relative to the place's tile origin. With
/// other mappings than uv that is a place in space, which moves no texture coordinates.
LinearWeight linearWeight(const MaterialNoise& material, const Placement& placement) {
  const MixWeight& mix = material.mix;
  if (mix.source == MixSource::constant)
    return {mix.weight, {}};
  if (mix.source != MixSource::direction)
    return {};
  const std::array<double, 2> way{mix.end[0] - mix.start[0], mix.end[1] - mix.start[1]};
  const double squaredLength = way[0] * way[0] + way[1] * way[1];
  LinearWeight weight{0.0, {way[0] / squaredLength, way[1] / squaredLength}};
  // The origin in texture coordinates: tile coordinates are a rotation of them over the scale.
  const double cosine = std::cos(material.rotation) * material.scale;
  const double sine = std::sin(material.rotation) * material.scale;
  const bool isMoved = material.mapping == Mapping::uv;
  const double tileX = isMoved ? double(placement.tileOriginX) : 0.0;
  const double tileY = isMoved ? double(placement.tileOriginY) : 0.0;
  weight.constant = weight.perUv[0] * (cosine * tileX - sine * tileY - mix.start[0]) +
                    weight.perUv[1] * (sine * tileX + cosine * tileY - mix.start[1]);
  return weight;
}

} // namespace

Lattice impactGrid(const TextonShape& shape, double impacts, const Placement& placement) {
  const double side = std::sqrt(supportArea(shape) / impacts);
  Lattice grid;
  if (!placement.periodic) {
    grid.columnsPerTile = cellsIn(shape.texelsPerTileX, side);
    grid.rowsPerTile = cellsIn(shape.texelsPerTileY, side);
    return grid;
  }
  grid.periodColumns = cellsIn(shape.texelsPerTileX * placement.periodTilesX, side);
  grid.periodRows = cellsIn(shape.texelsPerTileY * placement.periodTilesY, side);
  grid.columnsPerTile = grid.periodColumns / placement.periodTilesX;
  grid.rowsPerTile = grid.periodRows / placement.periodTilesY;
  return grid;
}

Lattice surfaceGrid(const TextonShape& shape, double impacts) {
  // [GLM17] section 6: lambda r^3 impacts.
  const double side =
      std::cbrt(supportArea(shape) * surfaceThickness(shape) / (kSurfaceImpacts * impacts));
  Lattice grid;
  grid.columnsPerTile = grid.rowsPerTile = cellsIn(shape.texelsPerTileX, side);
  return grid;
}

LatticeOrigin impactGridOrigin(const Lattice& grid, std::int64_t tileX, std::int64_t tileY) {
  const auto cell = [](std::int64_t tile, double perTile) {
    return std::int32_t(std::uint32_t(std::uint64_t(tile) * std::uint64_t(perTile)));
  };
  return {{cell(tileX, grid.columnsPerTile), cell(tileY, grid.rowsPerTile)}, {0.0f, 0.0f}};
}

shader::LichenTexton shaderTexton(const Bundle& bundle, const MaterialNoise& material,
                                  const Placement& placement) {
  const Noise& noise = bundle.noises[material.noise];
  shader::LichenTexton result{};
  if (noise.method != Method::texton)
    return result;
  const TextonShape& shape = noise.texton;
  result.texelsPerTileX = float(shape.texelsPerTileX);
  result.texelsPerTileY = float(shape.texelsPerTileY);
  result.coefficientsX = shape.coefficientsX;
  result.coefficientsY = shape.coefficientsY;
  result.frameX = int(shape.frameWidth());
  result.frameY = int(shape.frameHeight());
  result.order = shader::uint(shape.order);
  result.mipCount = shader::uint(shape.mipLevels);
  result.steps = shader::uint(shape.steps);
  result.pointProcess = material.pointProcess == PointProcess::poisson ? LICHEN_POINTS_POISSON
                                                                       : LICHEN_POINTS_STRATIFIED;
  if (shape.steps > 1) {
    const LinearWeight weight = linearWeight(material, placement);
    result.mixWeight = float(weight.constant);
    result.mixPerU = float(weight.perUv[0]);
    result.mixPerV = float(weight.perUv[1]);
  }
  if (material.mapping == Mapping::surface) {
    // [GLM17] proposition 3: the variance is lambda r / 3 times that of the texton.
    const double cube = shape.texelsPerTileX / surfaceGrid(shape, material.impacts).columnsPerTile;
    const double lambda = 1.0 / (cube * cube * cube);
    result.surfaceCubeTexels = float(cube);
    result.amplitude = float(1.0 / std::sqrt(lambda * surfaceThickness(shape) / 3.0));
    return result;
  }
  const Lattice grid = impactGrid(shape, material.impacts, placement);
  const double cellArea =
      shape.texelsPerTileX / grid.columnsPerTile * (shape.texelsPerTileY / grid.rowsPerTile);
  result.amplitude = float(std::sqrt(cellArea));
  return result;
}

} // namespace lichen
