// SPDX-License-Identifier: MIT
// The lattice's host side: periodic forms and integer origins, in double precision.
#include <lichen/lattice.h>

#include <algorithm>
#include <cmath>

namespace lichen {
namespace {

/// The integer part modulo 2^32 and the fraction of `value`, |value| < 2^53.
std::int32_t splitCell(double value, float& fraction) {
  const double cell = std::floor(value);
  // A fraction just below 1 must not round up to 1 in float: cells are half-open.
  fraction = std::min(float(value - cell), std::nextafter(1.0f, 0.0f));
  return std::int32_t(std::uint32_t(std::int64_t(cell)));
}

} // namespace

Lattice periodicLattice(double widthTiles, double heightTiles) {
  constexpr int kFewestColumns = 3; // fewer and a vertex neighbours itself
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
  LatticeOrigin origin;
  // j = 4 y is an integer; i = 2 sqrt(3) x - j / 2, and j / 2 = 2 y is an integer too, so only the
  // irrational term is rounded: absolute error 2^-52 of its value, 1e-8 cells at 10^7 tiles.
  const double columns = double(tileX) * kLatticeColumnsPerTile;
  const std::int32_t column = splitCell(columns, origin.fraction[0]);
  origin.cell[0] = std::int32_t(std::uint32_t(column) - 2u * std::uint32_t(std::uint64_t(tileY)));
  origin.cell[1] = std::int32_t(4u * std::uint32_t(std::uint64_t(tileY)));
  origin.fraction[1] = 0.0f;
  return origin;
}

} // namespace lichen
