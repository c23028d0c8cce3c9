// SPDX-License-Identifier: MIT
// Periodic lattices and integer tile origins, computed on the CPU.
#include <lichen/lattice.h>

#include <algorithm>
#include <cmath>

namespace lichen {
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

std::array<std::int32_t, 2> latticeCell(std::int64_t tileX, std::int64_t tileY) {
  // I = 7/2 x - J / 2 and J = 4 y, modulo 2^32.
  const auto halfX = std::uint64_t(tileX / 2);
  const auto y = std::uint64_t(tileY);
  return {std::int32_t(std::uint32_t(7u * halfX - 2u * y)), std::int32_t(std::uint32_t(4u * y))};
}

} // namespace lichen
