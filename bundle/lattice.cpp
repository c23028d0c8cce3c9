// SPDX-License-Identifier: MIT
// Periodic lattices and integer tile origins, computed on the CPU.
#include <lichen/lattice.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lichen {

std::string_view nameOf(Grain grain) {
  constexpr std::array<std::string_view, 3> kNames = {"none", "x", "y"};
  return kNames[std::size_t(grain)];
}

std::optional<Grain> grainFrom(std::string_view name) {
  for (const Grain grain : {Grain::x, Grain::y})
    if (name == nameOf(grain))
      return grain;
  return std::nullopt;
}

Lattice infiniteLattice(Grain grain) {
  Lattice lattice;
  if (grain == Grain::x)
    lattice.columnsPerTile /= kGrainStretch;
  if (grain == Grain::y)
    lattice.rowsPerTile /= kGrainStretch;
  return lattice;
}

Lattice periodicLattice(double widthTiles, double heightTiles, Grain grain) {
  constexpr int kFewestColumns = 3; // with fewer, a vertex is its own neighbour
  constexpr int kFewestRows = 4;
  Lattice lattice = infiniteLattice(grain);
  lattice.periodColumns =
      std::max(kFewestColumns, int(std::lround(widthTiles * lattice.columnsPerTile)));
  lattice.periodRows =
      std::max(kFewestRows, 2 * int(std::lround(heightTiles * lattice.rowsPerTile / 2.0)));
  lattice.columnsPerTile = lattice.periodColumns / widthTiles;
  lattice.rowsPerTile = lattice.periodRows / heightTiles;
  return lattice;
}

namespace {

constexpr std::int64_t kColumnsOfStep = 7;
constexpr std::int64_t kTilesOfStep = 2, kTilesOfStretchedStep = 4;
static_assert(kTilesOfStep * kLatticeColumnsPerTile == kColumnsOfStep);
static_assert(kTilesOfStretchedStep * kLatticeColumnsPerTile / kGrainStretch == kColumnsOfStep);

} // namespace

std::int64_t latticeOriginStep(Grain grain) {
  return grain == Grain::x ? kTilesOfStretchedStep : kTilesOfStep;
}

std::array<std::int32_t, 2> latticeCell(std::int64_t tileX, std::int64_t tileY, Grain grain) {
  // I = columnsPerTile x - J / 2 and J = rowsPerTile y, modulo 2^32.
  const auto steps = std::uint64_t(tileX / latticeOriginStep(grain));
  const auto halfRows = std::uint64_t(infiniteLattice(grain).rowsPerTile / 2.0);
  const std::uint64_t halfJ = halfRows * std::uint64_t(tileY);
  return {std::int32_t(std::uint32_t(std::uint64_t(kColumnsOfStep) * steps - halfJ)),
          std::int32_t(std::uint32_t(2u * halfJ))};
}

} // namespace lichen
