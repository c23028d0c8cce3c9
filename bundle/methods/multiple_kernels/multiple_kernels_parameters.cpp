// SPDX-License-Identifier: MIT
// A multiple-kernels noise and its material -> the members of the shader's constants that only this
// method has.
#include "methods/map_constants.h"
#include "methods/method_parameters.h"
#include "methods/split_origin.h"

#include <array>

namespace lichen {
namespace {

bool fits(Mapping) { return true; }

std::string_view obstacle(const shader::LichenNoise& noise, Mapping mapping) {
  const auto own = partOf<shader::LichenKernelsNoise>(noise);
  if (mapping != Mapping::solid && mapping != Mapping::surface)
    return "";
  if (own.cosines > 0)
    return "it has a pattern, which lies in a plane";
  return KernelWindow(own.window) == KernelWindow::gabor || mapping == Mapping::surface
             ? ""
             : "its kernels have a window on a square, and in solids all have gabor";
}

std::array<std::uint32_t, 2> texelsPerTile(const Noise& noise) {
  const auto& shared = noise.as<MultipleKernelsNoise>();
  return {std::uint32_t(shared.texelsPerTileX), std::uint32_t(shared.texelsPerTileY)};
}

/// The cells of kernels differ; these are groups of kKernelTiles tiles, which hold whole cells of
/// all. With a period the kernels' cells divide that.
Lattice cells(const shader::LichenNoise&, const MaterialNoise&, const Placement& placement) {
  Lattice lattice;
  lattice.columnsPerTile = lattice.rowsPerTile = 1.0 / kKernelTiles;
  if (placement.periodic)
    lattice.periodColumns = lattice.periodRows = 1;
  return lattice;
}

std::array<std::int64_t, 2> originStep(const shader::LichenNoise&, const MaterialNoise&) {
  return {kKernelTiles, kKernelTiles};
}

std::array<std::int32_t, 2> cellOf(const shader::LichenNoise&, const MaterialNoise&,
                                   std::int64_t tileX, std::int64_t tileY) {
  const auto group = [](std::int64_t tile) {
    return std::int32_t(std::uint32_t(std::uint64_t(tile / kKernelTiles)));
  };
  return {group(tileX), group(tileY)};
}

void setMap(const Bundle& bundle, const Noise&, const NoiseMap& map, shader::LichenMap& constants) {
  const auto& own = map.as<MultipleKernelsMap>();
  setImage(constants, bundle.tables[own.kernels]);
  constants.dimensions = shader::uint(own.dimensions);
  setDecoding(constants, bundle, map, own.inverseTable);
  // Solid noise has a third slope, which no table knows.
  if (map.encoding == ValueEncoding::slope && own.inverseTable)
    setLinearRows(constants, map, bundle.tables[*own.inverseTable]);
}

void setNoise(const Bundle&, const Noise& noise, shader::LichenNoise& constants) {
  const auto& shared = noise.as<MultipleKernelsNoise>();
  setPart(constants,
          shader::LichenKernelsNoise{shader::uint(shared.kernels), shader::uint(shared.rings),
                                     shader::uint(shared.window), shader::uint(shared.cosines)});
}

void setMaterial(const shader::LichenNoise& noise, const MaterialNoise& material,
                 const Placement& placement, shader::LichenMaterial& constants) {
  shader::LichenKernelsMaterial part{};
  const bool isSolid = material.mapping == Mapping::solid;
  if (isSolid || material.mapping == Mapping::surface) {
    // On surfaces the axes are the axes of space, in tile widths.
    const std::array<SplitOrigin, 3> origin =
        isSolid ? solidOrigin(noise, material, placement, kKernelTiles)
                : std::array{splitOrigin(placement.tileOriginX, 0.0, kKernelTiles),
                             splitOrigin(placement.tileOriginY, 0.0, kKernelTiles),
                             splitOrigin(placement.tileOriginZ, 0.0, kKernelTiles)};
    const auto group = [&](std::size_t axis) {
      return std::int32_t(std::uint32_t(std::uint64_t(origin[axis].tile / kKernelTiles)));
    };
    constants.seedWord = latticeSeed(material.seed, isSolid ? kSolidPlane : kSurfacePlane);
    constants.offsetX = origin[0].offset;
    constants.offsetY = origin[1].offset;
    constants.cellI = group(0);
    constants.cellJ = group(1);
    part = {group(2), origin[2].offset};
  }
  setPart(constants, part);
}

std::uint32_t features(const shader::LichenNoise& noise, const MaterialNoise&) {
  const auto kernels = partOf<shader::LichenKernelsNoise>(noise);
  return featureIf(kernels.rings > 0, LICHEN_FEATURE_RING_KERNELS) |
         featureIf(kernels.window != LICHEN_WINDOW_GABOR, LICHEN_FEATURE_SQUARE_KERNELS) |
         featureIf(kernels.cosines > 0, LICHEN_FEATURE_PATTERNS);
}

} // namespace

extern const MethodParameters kMultipleKernelsParameters{.fits = fits,
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
