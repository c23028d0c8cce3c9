// SPDX-License-Identifier: MIT
// A multiple-kernels noise and its material -> the members of the shader's constants that only this
// method has.
#include "methods/map_constants.h"
#include "methods/method_part.h"
#include "multiple_kernels_format.h"

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

std::array<std::int64_t, 2> MultipleKernelsFormat::originStep() const {
  return {kKernelTiles, kKernelTiles};
}

std::array<std::int32_t, 2> MultipleKernelsFormat::cellOf(const Lattice&, std::int64_t tileX,
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
}

void MultipleKernelsFormat::setNoise(const Noise& noise, shader::LichenNoise& constants) const {
  const auto& shared = noise.as<MultipleKernelsNoise>();
  setPart(constants,
          shader::LichenKernelsNoise{shader::uint(shared.kernels), shader::uint(shared.rings),
                                     shader::uint(shared.window), 0});
}

void MultipleKernelsFormat::setMaterial(const shader::LichenNoise&, const MaterialNoise&,
                                        const Placement&, shader::LichenMaterial& constants) const {
  setPart(constants, shader::LichenKernelsMaterial{LICHEN_POINTS_STRATIFIED});
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
