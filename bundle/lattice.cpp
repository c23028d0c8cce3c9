// SPDX-License-Identifier: MIT
// Periodic lattices and integer tile origins, computed on the CPU.
#include <lichen/lattice.h>

#include <algorithm>
#include <cmath>

namespace lichen {
namespace {

/// 2 sqrt(3) minus its nearest double, kLatticeColumnsPerTile.
constexpr double kColumnsRemainder = 2.0070168443613806e-16;

} // namespace

Lattice periodicLattice(double widthTiles, double heightTiles) {
  constexpr int kFewestColumns = 3; // with fewer, a vertex is its own neighbour
  constexpr int kFewestRows = 4;
  Lattice lattice;
  lattice.periodColumns =
      std::max(kFewestColumns, int(std::lround(widthTiles * kLatticeColumnsPerTile)));
  lattice.periodRows =
      std::max(kFewestRows, 2 * int(std::lround(heightTiles * kLatticeRowsPerTile / 2.0)));
  lattice.columnsPerTile = lattice.periodColumns / widthTiles;
  lattice.rowsPerTile = lattice.periodRows / heightTiles;
  return lattice;
}

LatticeOrigin latticeOrigin(std::int64_t tileX, std::int64_t tileY) {
  // j = 4 y is an integer; i = 2 sqrt(3) x - j / 2, where j / 2 = 2 y is an integer too. Two
  // doubles hold the product with x; one alone is off by 5e-4 cells at 2^40 tiles.
  const auto x = double(tileX);
  const double columns = x * kLatticeColumnsPerTile;
  const double rest = std::fma(x, kLatticeColumnsPerTile, -columns) + x * kColumnsRemainder;
  double column = std::floor(columns);
  double fraction = columns - column + rest;
  column += std::floor(fraction);
  fraction -= std::floor(fraction);

  LatticeOrigin origin;
  const auto whole = std::uint64_t(std::int64_t(column));
  origin.cell[0] = std::int32_t(std::uint32_t(whole - 2u * std::uint64_t(tileY)));
  origin.cell[1] = std::int32_t(std::uint32_t(4u * std::uint64_t(tileY)));
  // A fraction just below 1 must not round up to 1 in float, because cells are half-open.
  origin.fraction[0] = std::min(float(fraction), std::nextafter(1.0f, 0.0f));
  return origin;
}

} // namespace lichen
