// SPDX-License-Identifier: MIT
// Shape of the textons, mean number of impacts -> the grid of cells, and the shader's constants.
// Whole cells in a tile make integer tile origins exact; the amplitude is that of the density that
// results, so the covariance is exact too, and only the number of impacts is rounded.
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

} // namespace

Lattice impactGrid(const TextonShape& shape, double impacts, const Placement& placement) {
  // A B-spline of order k reaches (k + 1) / 2 texels beyond the centres of the coefficients.
  const double supportX = shape.coefficientsX + shape.order;
  const double supportY = shape.coefficientsY + shape.order;
  const double side = std::sqrt(supportX * supportY / impacts);
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
  const Lattice grid = impactGrid(shape, material.impacts, placement);
  const double cellArea =
      shape.texelsPerTileX / grid.columnsPerTile * (shape.texelsPerTileY / grid.rowsPerTile);
  result.amplitude = float(std::sqrt(cellArea));
  return result;
}

} // namespace lichen
