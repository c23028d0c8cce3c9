// SPDX-License-Identifier: MIT
// A local random-phase noise and its material -> the members of the shader's constants that only
// this method has.
#include "methods/map_constants.h"
#include "methods/method_parameters.h"
#include "methods/split_origin.h"

#include <lichen/structure_texel.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace lichen {
namespace {

/// With fewer columns or rows a vertex is its own neighbour. Rows are even.
constexpr double kFewestColumns = 3.0, kFewestRows = 4.0;

/// The first octave that has enough cells in a period, as those below it have its lattice then.
int firstOctave(const shader::LichenNoise& noise, const Placement& placement) {
  if (!placement.periodic)
    return 0;
  const shader::LichenCosinesNoise part = partOf<shader::LichenCosinesNoise>(noise);
  int octave = 0;
  while (
      octave + 1 < int(kMostOctaves) &&
      (std::ldexp(placement.periodTilesX * part.columns / kOctaveTiles, octave) < kFewestColumns ||
       std::ldexp(placement.periodTilesY * part.rows / kOctaveTiles, octave) < kFewestRows))
    ++octave;
  return octave;
}

/// LichenCosinesNoise::structure
shader::uint structureWord(const CosineStructure& structure) {
  if (structure.columns == 0)
    return 0;
  const auto log2 = [](int side) { return shader::uint(std::bit_width(unsigned(side)) - 1); };
  return log2(structure.columns) | log2(structure.rows) << 4 |
         shader::uint(structure.offsets) << 8 |
         shader::uint(std::lround(structure.turbulence * 0xFFFF)) << 16;
}

/// Whether tiles keep what repeats in the exemplar: a period must repeat it too.
bool isGuided(const Placement& placement) {
  const auto isWhole = [](double tiles) { return tiles == std::round(tiles); };
  return !placement.periodic ||
         (isWhole(placement.periodTilesX) && isWhole(placement.periodTilesY));
}

/// Sets the cubes of solid noise, and the position of the tile origin in them: a body-centred cubic
/// lattice whose vertices (i, j, k) lie at (i, j, k) - (i + j + k) / 6 cubes.
void setSolid(const shader::LichenNoise& noise, const MaterialNoise& material,
              const Placement& placement, shader::LichenMaterial& constants,
              shader::LichenCosinesMaterial& part) {
  // A window of edge 1 is as wide as one of 0.73 cubes: the root of 0.1733 / 0.3265, their mean
  // square frequencies. More cubes leave fewer strokes in planes other than the exemplar's.
  constexpr double kCubesPerEdge = 0.84;
  const shader::LichenCosinesNoise own = partOf<shader::LichenCosinesNoise>(noise);
  const auto cubesIn = [](double edges) {
    return std::max(1LL, std::llround(edges * kCubesPerEdge));
  };
  const std::int64_t across = cubesIn(own.columns);
  const std::int64_t down = cubesIn(0.5 * std::numbers::sqrt3 * own.rows);
  constants.columnsPerTile = float(across) / kOctaveTiles;
  constants.rowsPerTile = float(down) / kOctaveTiles;
  constants.seedWord = latticeSeed(material.seed, kSolidPlane);
  // Whole vertices lie three cubes apart along an axis.
  constexpr std::int64_t kStep = 3 * kOctaveTiles;
  const auto [x, y, z] = solidOrigin(noise, material, placement, kStep);
  const std::array<std::int64_t, 3> thirds{x.tile / kStep * across, y.tile / kStep * down,
                                           z.tile / kStep * across};
  const std::int64_t shift = thirds[0] + thirds[1] + thirds[2];
  const auto cell = [&](std::size_t axis) {
    return std::int32_t(std::uint32_t(std::uint64_t(3 * thirds[axis] + shift)));
  };
  constants.offsetX = x.offset;
  constants.offsetY = y.offset;
  constants.cellI = cell(0);
  constants.cellJ = cell(1);
  part.cellK = cell(2);
  part.offsetZ = z.offset;
}

bool fits(Mapping mapping) { return mapping != Mapping::surface; }

std::string_view obstacle(const shader::LichenNoise& noise, Mapping mapping) {
  const bool hasStructure = partOf<shader::LichenCosinesNoise>(noise).structure != 0;
  return mapping == Mapping::solid && hasStructure ? "it has a structure, which lies in a plane"
                                                   : "";
}

std::array<std::uint32_t, 2> texelsPerTile(const Noise& noise) {
  const auto& shared = noise.as<LocalRandomPhaseNoise>();
  return {std::uint32_t(shared.texelsPerTileX), std::uint32_t(shared.texelsPerTileY)};
}

Lattice cells(const shader::LichenNoise& noise, const MaterialNoise&, const Placement& placement) {
  const shader::LichenCosinesNoise part = partOf<shader::LichenCosinesNoise>(noise);
  Lattice lattice;
  lattice.columnsPerTile = double(part.columns) / kOctaveTiles;
  lattice.rowsPerTile = double(part.rows) / kOctaveTiles;
  if (!placement.periodic)
    return lattice;
  const int octave = firstOctave(noise, placement);
  const auto cellsIn = [&](double tiles, double perTile, double fewest) {
    constexpr double kMostCells = 1 << 18; // of half the rows; all octaves' cells fit an int
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

std::array<std::int64_t, 2> originStep(const shader::LichenNoise&, const MaterialNoise&) {
  return {kOctaveTiles, kOctaveTiles};
}

std::array<std::int32_t, 2> cellOf(const shader::LichenNoise& noise, const MaterialNoise& material,
                                   std::int64_t tileX, std::int64_t tileY) {
  const Lattice lattice = cells(noise, material, {});
  // I = columns x - J / 2 and J = rows y, modulo 2^32; x and y in units of kOctaveTiles tiles.
  const auto columns = std::uint64_t(std::llround(lattice.columnsPerTile * kOctaveTiles));
  const auto halfRows = std::uint64_t(std::llround(0.5 * lattice.rowsPerTile * kOctaveTiles));
  const auto x = std::uint64_t(tileX / kOctaveTiles);
  const auto y = std::uint64_t(tileY / kOctaveTiles);
  return {std::int32_t(std::uint32_t(columns * x - halfRows * y)),
          std::int32_t(std::uint32_t(2u * halfRows * y))};
}

void setMap(const Bundle& bundle, const Noise&, const NoiseMap& map, shader::LichenMap& constants) {
  const auto& own = map.as<LocalRandomPhaseMap>();
  setImage(constants, bundle.tables[own.cosines]);
  constants.dimensions = shader::uint(own.dimensions);
  std::vector<double> losses;
  for (const double deviation : own.structureDeviations)
    losses.push_back(1.0 - deviation * deviation);
  if (!losses.empty())
    losses.push_back(1.0); // beyond the last level
  constants.mipRetained0 = retainedAmplitudes(losses);
  std::array<float, 3> perInteger{};
  for (std::size_t c = 0; c < own.structureAmplitudes.size(); ++c)
    perInteger[c] = float(own.structureAmplitudes[c] / kMostStructureInteger);
  constants.sumFactor = {perInteger[0], perInteger[1], perInteger[2], 0.0f};
  setDecoding(constants, bundle, map, own.inverseTable);
  // Solid noise has a third slope, which no table knows.
  if (map.encoding == ValueEncoding::slope && own.inverseTable)
    setLinearRows(constants, map, bundle.tables[*own.inverseTable]);
}

void setNoise(const Bundle&, const Noise& noise, shader::LichenNoise& constants) {
  const auto& shared = noise.as<LocalRandomPhaseNoise>();
  std::array<shader::uint, 3> counts{};
  for (std::size_t octave = 0; octave < shared.cosines.size(); ++octave)
    counts[octave / 4] |= shader::uint(shared.cosines[octave]) << (8 * (octave % 4));
  setPart(constants, shader::LichenCosinesNoise{
                         counts[0], counts[1], counts[2], shader::uint(shared.variants),
                         shader::uint(shared.columns), shader::uint(shared.rows),
                         shader::uint(shared.cosineCount()), structureWord(shared.structure)});
}

void setMaterial(const shader::LichenNoise& noise, const MaterialNoise& material,
                 const Placement& placement, shader::LichenMaterial& constants) {
  shader::LichenCosinesMaterial part{};
  part.firstOctave = firstOctave(noise, placement);
  part.guided = shader::uint(isGuided(placement));
  if (material.mapping == Mapping::solid)
    setSolid(noise, material, placement, constants, part);
  setPart(constants, part);
}

std::uint32_t features(const shader::LichenNoise& noise, const MaterialNoise&) {
  return featureIf(partOf<shader::LichenCosinesNoise>(noise).structure != 0,
                   LICHEN_FEATURE_STRUCTURES);
}

} // namespace

extern const MethodParameters kLocalRandomPhaseParameters{.fits = fits,
                                                          .obstacle = obstacle,
                                                          .texelsPerTile = texelsPerTile,
                                                          .readsTexels = true,
                                                          .features = features,
                                                          .cells = cells,
                                                          .originStep = originStep,
                                                          .cellOf = cellOf,
                                                          .setMap = setMap,
                                                          .setNoise = setNoise,
                                                          .setMaterial = setMaterial};

} // namespace lichen
