// SPDX-License-Identifier: MIT
// A tiling noise and its material -> the tiling-only members of the shader's constants.
#include "methods/map_constants.h"
#include "methods/method_part.h"
#include "tiling_format.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace lichen {
namespace {

/// Tiles that are rotated have no grain: their streaks run in all directions.
Grain grainOf(const shader::LichenNoise& noise, const MaterialNoise& material) {
  return material.tileRotation > 1 ? Grain::none : Grain(tilingPart(noise).grain);
}

static_assert(int(Grain::none) == LICHEN_GRAIN_NONE && int(Grain::x) == LICHEN_GRAIN_X &&
              int(Grain::y) == LICHEN_GRAIN_Y);

} // namespace

Lattice TilingFormat::cells(const shader::LichenNoise& noise, const MaterialNoise& material,
                            const Placement& placement) const {
  const Grain grain = grainOf(noise, material);
  return placement.periodic ? periodicLattice(placement.periodTilesX, placement.periodTilesY, grain)
                            : infiniteLattice(grain);
}

std::array<std::int64_t, 2> TilingFormat::originStep(const shader::LichenNoise& noise,
                                                     const MaterialNoise& material) const {
  return {latticeOriginStep(grainOf(noise, material)), 1};
}

std::array<std::int32_t, 2> TilingFormat::cellOf(const shader::LichenNoise& noise,
                                                 const MaterialNoise& material, std::int64_t tileX,
                                                 std::int64_t tileY) const {
  return latticeCell(tileX, tileY, grainOf(noise, material));
}

void TilingFormat::setMap(const Bundle& bundle, const Noise& noise, const NoiseMap& map,
                          shader::LichenMap& constants) const {
  const auto& tiling = map.as<TilingMap>();
  const Table& image = bundle.tables[tiling.gaussian];
  setImage(constants, image);
  constants.dimensions = shader::uint(tiling.dimensions);
  constants.levelOffset = levelOffset(image, tileSize(bundle, noise));
  constants.interpolationLoss = fetchLosses(image).front();
  setDecoding(constants, bundle, map, tiling.inverseTable);
}

void TilingFormat::setNoise(const Bundle&, const Noise& noise,
                            shader::LichenNoise& constants) const {
  setOffsetSteps(constants);
  setPart(constants, shader::LichenTilingNoise{shader::uint(noise.as<TilingNoise>().grain)});
}

void TilingFormat::setMaterial(const shader::LichenNoise&, const MaterialNoise& material,
                               const Placement&, shader::LichenMaterial& constants) const {
  setPart(constants,
          shader::LichenTilingMaterial{float(material.blendSharpness), material.tileRotation});
}

bool takesTileRotation(const shader::LichenNoise& noise, std::uint32_t tileRotation) {
  // Only these map texels onto texels.
  return tileRotation <= 2 || (tileRotation == 4 && (Method(noise.method) != Method::tiling ||
                                                     noise.tileAspect == 1.0f));
}

shader::LichenTilingMaterial tilingPart(const shader::LichenMaterial& material) {
  return partOf<shader::LichenTilingMaterial>(material);
}

void setPart(shader::LichenMaterial& material, const shader::LichenTilingMaterial& part) {
  setPartOf(material, part);
}

shader::LichenTilingNoise tilingPart(const shader::LichenNoise& noise) {
  return partOf<shader::LichenTilingNoise>(noise);
}

void setPart(shader::LichenNoise& noise, const shader::LichenTilingNoise& part) {
  setPartOf(noise, part);
}

} // namespace lichen
