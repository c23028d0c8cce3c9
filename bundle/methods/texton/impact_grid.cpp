// SPDX-License-Identifier: MIT
// Texton shape, mean number of impacts -> the grid of cells.
// A whole number of cells per tile makes integer tile origins exact. The amplitude uses the
// resulting density, so the covariance is exact too; only the number of impacts is rounded.
// Source: [GLM17] Galerne, Leclaire and Moisan 2017, section 6.
#include "impact_grid.h"

#include <algorithm>
#include <cmath>

namespace lichen {
namespace {

/// The number of cells whose total length is closest to a length: at least one, and few enough that
/// an int holds three periods.
int cellsIn(double lengthTexels, double sideTexels) {
  constexpr double kMostCells = 1 << 29;
  return int(std::clamp(std::round(lengthTexels / sideTexels), 1.0, kMostCells));
}

/// A B-spline of order k extends (k + 1) / 2 texels beyond the centres of the coefficients.
double supportArea(const TextonShape& shape) {
  return double(shape.coefficientsX + shape.order) * double(shape.coefficientsY + shape.order);
}

} // namespace

double surfaceThickness(const TextonShape& shape) { return std::sqrt(supportArea(shape)); }

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
  // [GLM17] section 6: lambda r^3 impacts cover a point.
  const double side =
      std::cbrt(supportArea(shape) * surfaceThickness(shape) / (kSurfaceImpacts * impacts));
  Lattice grid;
  grid.columnsPerTile = grid.rowsPerTile = cellsIn(shape.texelsPerTileX, side);
  return grid;
}

std::array<std::int32_t, 2> impactGridCell(const Lattice& grid, std::int64_t tileX,
                                           std::int64_t tileY) {
  const auto cell = [](std::int64_t tile, double perTile) {
    return std::int32_t(std::uint32_t(std::uint64_t(tile) * std::uint64_t(perTile)));
  };
  return {cell(tileX, grid.columnsPerTile), cell(tileY, grid.rowsPerTile)};
}

} // namespace lichen
