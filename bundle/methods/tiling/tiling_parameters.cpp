// SPDX-License-Identifier: MIT
// A tiling noise and its material -> the tiling-only members of the shader's constants.
#include "methods/map_constants.h"
#include "methods/method_parameters.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace lichen {
namespace {

/// Tiles that are rotated have no grain: their streaks run in all directions.
Grain grainOf(const shader::LichenNoise& noise, const MaterialNoise& material) {
  return material.tileRotation > 1 ? Grain::none
                                   : Grain(partOf<shader::LichenTilingNoise>(noise).grain);
}

static_assert(int(Grain::none) == LICHEN_GRAIN_NONE && int(Grain::x) == LICHEN_GRAIN_X &&
              int(Grain::y) == LICHEN_GRAIN_Y);

bool fits(Mapping mapping) { return mapping == Mapping::uv || mapping == Mapping::triplanar; }

std::size_t imageOf(const NoiseMap& map) { return map.as<TilingMap>().gaussian; }

Lattice cells(const shader::LichenNoise& noise, const MaterialNoise& material,
              const Placement& placement) {
  const Grain grain = grainOf(noise, material);
  return placement.periodic ? periodicLattice(placement.periodTilesX, placement.periodTilesY, grain)
                            : infiniteLattice(grain);
}

std::array<std::int64_t, 2> originStep(const shader::LichenNoise& noise,
                                       const MaterialNoise& material) {
  return {latticeOriginStep(grainOf(noise, material)), 1};
}

std::array<std::int32_t, 2> cellOf(const shader::LichenNoise& noise, const MaterialNoise& material,
                                   std::int64_t tileX, std::int64_t tileY) {
  return latticeCell(tileX, tileY, grainOf(noise, material));
}

void setMap(const Bundle& bundle, const Noise& noise, const NoiseMap& map,
            shader::LichenMap& constants) {
  const auto& tiling = map.as<TilingMap>();
  const Table& image = bundle.tables[tiling.gaussian];
  setImage(constants, image);
  constants.dimensions = shader::uint(tiling.dimensions);
  constants.levelOffset = levelOffset(image, tileSize(bundle, noise));
  constants.interpolationLoss = fetchLosses(image).front();
  setDecoding(constants, bundle, map, tiling.inverseTable);
}

void setNoise(const Bundle&, const Noise& noise, shader::LichenNoise& constants) {
  setOffsetSteps(constants);
  setPart(constants, shader::LichenTilingNoise{shader::uint(noise.as<TilingNoise>().grain)});
}

void setMaterial(const shader::LichenNoise&, const MaterialNoise& material, const Placement&,
                 shader::LichenMaterial& constants) {
  setPart(constants,
          shader::LichenTilingMaterial{float(material.blendSharpness), material.tileRotation});
}

std::uint32_t features(const shader::LichenNoise& noise, const MaterialNoise& material) {
  return featureIf(material.tileRotation > 1, LICHEN_FEATURE_TILE_ROTATION) |
         featureIf(material.blendSharpness != 1.0, LICHEN_FEATURE_BLEND_SHARPNESS) |
         featureIf(partOf<shader::LichenTilingNoise>(noise).grain != LICHEN_GRAIN_NONE,
                   LICHEN_FEATURE_GRAIN);
}

} // namespace

extern const MethodParameters kTilingParameters{.fits = fits,
                                                .imageOf = imageOf,
                                                .lastChannelIsAlpha = true,
                                                .features = features,
                                                .cells = cells,
                                                .originStep = originStep,
                                                .cellOf = cellOf,
                                                .setMap = setMap,
                                                .setNoise = setNoise,
                                                .setMaterial = setMaterial};

bool takesTileRotation(const shader::LichenNoise& noise, std::uint32_t tileRotation) {
  // Only these map texels onto texels.
  return tileRotation <= 2 || (tileRotation == 4 && (Method(noise.method) != Method::tiling ||
                                                     noise.tileAspect == 1.0f));
}

TableKind tableKindOf(const TilingMap& map) {
  return map.inverseTable ? TableKind::joint : TableKind::none;
}

std::string_view nameOf(TableKind kind) {
  constexpr std::array<std::string_view, 2> kNames = {"joint", "none"};
  return kNames[std::size_t(kind)];
}

} // namespace lichen
