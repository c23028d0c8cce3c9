// SPDX-License-Identifier: MIT
#include <lichen/lattice.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace lichen;

TEST_CASE("the lattice hash has its published test vectors") {
  // From an independent implementation of the two formulas in another language.
  CHECK(pcg(0u) == 129708002u);
  CHECK(pcg(1u) == 2831084092u);
}

TEST_CASE("an integer tile origin is where the skewed coordinates say, exactly") {
  const LatticeOrigin origin = latticeOrigin(10000000, -3);
  const long double column = 10000000.0L * 3.46410161513775458705489268301174488L;
  CHECK(origin.cell[0] == std::int32_t(std::floor(column)) + 6);
  CHECK(origin.cell[1] == -12);
  CHECK(std::abs(origin.fraction[0] - float(column - std::floor(column))) < 1e-7f);
  CHECK(origin.fraction[1] == 0.0f);
}

TEST_CASE("a periodic lattice has an even number of rows and covers its rectangle") {
  for (const double side : {0.4, 1.0, 1.37, 2.0, 4.0, 16.0}) {
    const Lattice lattice = periodicLattice(side, side);
    CHECK(lattice.periodRows % 2 == 0);
    CHECK(lattice.periodColumns / lattice.columnsPerTile == Approx(side));
    CHECK(lattice.periodRows / lattice.rowsPerTile == Approx(side));
  }
}
