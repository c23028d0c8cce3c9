// SPDX-License-Identifier: MIT
// A multiple-kernels noise and its material -> the members of the shader's constants that only this
// method has.
#include "methods/map_constants.h"
#include "methods/method_part.h"
#include "methods/solid_origin.h"
#include "multiple_kernels_format.h"

#include <array>

namespace lichen {

/// The cells of kernels differ; these are groups of kKernelTiles tiles, which hold whole cells of
/// all. With a period the kernels' cells divide that.
Lattice MultipleKernelsFormat::cells(const shader::LichenNoise&, const MaterialNoise&,
                                     const Placement& placement) const {
  Lattice lattice;
  lattice.columnsPerTile = lattice.rowsPerTile = 1.0 / kKernelTiles;
  if (placement.periodic)
    lattice.periodColumns = lattice.periodRows = 1;
  return lattice;
}

std::array<std::int64_t, 2> MultipleKernelsFormat::originStep(const shader::LichenNoise&,
                                                              const MaterialNoise&) const {
  return {kKernelTiles, kKernelTiles};
}

std::array<std::int32_t, 2> MultipleKernelsFormat::cellOf(const shader::LichenNoise&,
                                                          const MaterialNoise&, std::int64_t tileX,
                                                          std::int64_t tileY) const {
  const auto group = [](std::int64_t tile) {
    return std::int32_t(std::uint32_t(std::uint64_t(tile / kKernelTiles)));
  };
  return {group(tileX), group(tileY)};
}

void MultipleKernelsFormat::setMap(const Bundle& bundle, const Noise&, const NoiseMap& map,
                                   shader::LichenMap& constants) const {
  const auto& own = map.as<MultipleKernelsMap>();
  setImage(constants, bundle.tables[own.kernels]);
  constants.dimensions = shader::uint(own.dimensions);
  setDecoding(constants, bundle, map, own.inverseTable);
  // Solid noise has a third slope, which no table knows.
  if (map.encoding == ValueEncoding::slope && own.inverseTable)
    setLinearRows(constants, map, bundle.tables[*own.inverseTable]);
}

void MultipleKernelsFormat::setNoise(const Bundle&, const Noise& noise,
                                     shader::LichenNoise& constants) const {
  const auto& shared = noise.as<MultipleKernelsNoise>();
  setPart(constants,
          shader::LichenKernelsNoise{shader::uint(shared.kernels), shader::uint(shared.rings),
                                     shader::uint(shared.window), shader::uint(shared.cosines)});
}

void MultipleKernelsFormat::setMaterial(const shader::LichenNoise& noise,
                                        const MaterialNoise& material, const Placement& placement,
                                        shader::LichenMaterial& constants) const {
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
    part = {shader::uint(isSolid), shader::uint(!isSolid), group(2), origin[2].offset};
  }
  setPart(constants, part);
}

shader::LichenKernelsMaterial kernelsPart(const shader::LichenMaterial& material) {
  return partOf<shader::LichenKernelsMaterial>(material);
}

void setPart(shader::LichenMaterial& material, const shader::LichenKernelsMaterial& part) {
  setPartOf(material, part);
}

shader::LichenKernelsNoise kernelsPart(const shader::LichenNoise& noise) {
  return partOf<shader::LichenKernelsNoise>(noise);
}

void setPart(shader::LichenNoise& noise, const shader::LichenKernelsNoise& part) {
  setPartOf(noise, part);
}

} // namespace lichen
