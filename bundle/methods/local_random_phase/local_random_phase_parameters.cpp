// SPDX-License-Identifier: MIT
// A local random-phase noise and its material -> the members of the shader's constants that only
// this method has.
#include "local_random_phase_format.h"
#include "methods/map_constants.h"
#include "methods/method_part.h"

#include <algorithm>
#include <cmath>

namespace lichen {
namespace {

/// With fewer columns or rows a vertex is its own neighbour. Rows are even.
constexpr double kFewestColumns = 3.0, kFewestRows = 4.0;

/// The first octave that has enough cells in a period, as those below it have its lattice then.
int firstOctave(const shader::LichenNoise& noise, const Placement& placement) {
  if (!placement.periodic)
    return 0;
  const shader::LichenCosinesNoise part = cosinesPart(noise);
  int octave = 0;
  while (
      octave + 1 < int(kMostOctaves) &&
      (std::ldexp(placement.periodTilesX * part.columns / kOctaveTiles, octave) < kFewestColumns ||
       std::ldexp(placement.periodTilesY * part.rows / kOctaveTiles, octave) < kFewestRows))
    ++octave;
  return octave;
}

} // namespace

Lattice LocalRandomPhaseFormat::cells(const shader::LichenNoise& noise, const MaterialNoise&,
                                      const Placement& placement) const {
  const shader::LichenCosinesNoise part = cosinesPart(noise);
  Lattice lattice;
  lattice.columnsPerTile = double(part.columns) / kOctaveTiles;
  lattice.rowsPerTile = double(part.rows) / kOctaveTiles;
  if (!placement.periodic)
    return lattice;
  const int octave = firstOctave(noise, placement);
  const auto cellsIn = [&](double tiles, double perTile, double fewest) {
    constexpr double kMostCells = 1 << 18; // of half the rows; an int holds those of all octaves
    return std::clamp(std::round(std::ldexp(tiles * perTile, octave)), fewest, kMostCells);
  };
  lattice.periodColumns =
      int(cellsIn(placement.periodTilesX, lattice.columnsPerTile, kFewestColumns));
  lattice.periodRows =
      2 * int(cellsIn(placement.periodTilesY, 0.5 * lattice.rowsPerTile, 0.5 * kFewestRows));
  lattice.columnsPerTile = lattice.periodColumns / placement.periodTilesX;
  lattice.rowsPerTile = lattice.periodRows / placement.periodTilesY;
  return lattice;
}

std::array<std::int64_t, 2> LocalRandomPhaseFormat::originStep() const {
  return {kOctaveTiles, kOctaveTiles};
}

std::array<std::int32_t, 2> LocalRandomPhaseFormat::cellOf(const Lattice& cells, std::int64_t tileX,
                                                           std::int64_t tileY) const {
  // I = columns x - J / 2 and J = rows y, modulo 2^32; x and y in units of kOctaveTiles tiles.
  const auto columns = std::uint64_t(std::llround(cells.columnsPerTile * kOctaveTiles));
  const auto halfRows = std::uint64_t(std::llround(0.5 * cells.rowsPerTile * kOctaveTiles));
  const auto x = std::uint64_t(tileX / kOctaveTiles);
  const auto y = std::uint64_t(tileY / kOctaveTiles);
  return {std::int32_t(std::uint32_t(columns * x - halfRows * y)),
          std::int32_t(std::uint32_t(2u * halfRows * y))};
}

void LocalRandomPhaseFormat::setMap(const Bundle& bundle, const Noise&, const NoiseMap& map,
                                    shader::LichenMap& constants) const {
  const auto& own = map.as<LocalRandomPhaseMap>();
  setImage(constants, bundle.tables[own.cosines]);
  constants.dimensions = shader::uint(own.dimensions);
  setDecoding(constants, bundle, map, own.inverseTable);
}

void LocalRandomPhaseFormat::setNoise(const Noise& noise, shader::LichenNoise& constants) const {
  const auto& shared = noise.as<LocalRandomPhaseNoise>();
  std::array<shader::uint, 3> counts{};
  for (std::size_t octave = 0; octave < shared.cosines.size(); ++octave)
    counts[octave / 4] |= shader::uint(shared.cosines[octave]) << (8 * (octave % 4));
  setPart(constants,
          shader::LichenCosinesNoise{counts[0], counts[1], counts[2], shader::uint(shared.variants),
                                     shader::uint(shared.columns), shader::uint(shared.rows),
                                     shader::uint(shared.cosineCount()), 0});
}

void LocalRandomPhaseFormat::setMaterial(const shader::LichenNoise& noise, const MaterialNoise&,
                                         const Placement& placement,
                                         shader::LichenMaterial& constants) const {
  setPart(constants, shader::LichenCosinesMaterial{firstOctave(noise, placement)});
}

shader::LichenCosinesMaterial cosinesPart(const shader::LichenMaterial& material) {
  return partOf<shader::LichenCosinesMaterial>(material);
}

void setPart(shader::LichenMaterial& material, const shader::LichenCosinesMaterial& part) {
  setPartOf(material, part);
}

shader::LichenCosinesNoise cosinesPart(const shader::LichenNoise& noise) {
  return partOf<shader::LichenCosinesNoise>(noise);
}

void setPart(shader::LichenNoise& noise, const shader::LichenCosinesNoise& part) {
  setPartOf(noise, part);
}

} // namespace lichen
