// SPDX-License-Identifier: MIT
// A texton noise and its material -> the texton-only members of the shader's constants.
#include "impact_grid.h"
#include "methods/map_constants.h"
#include "methods/method_parameters.h"

#include <algorithm>
#include <cmath>

namespace lichen {
namespace {

/// The n x n diagonal matrix of n values, row-major.
std::vector<double> diagonal(const std::vector<double>& values) {
  const std::size_t n = values.size();
  std::vector<double> matrix(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i)
    matrix[i * n + i] = values[i];
  return matrix;
}

/// Sets the retained amplitudes of each channel. They are 0 for a constant channel, so that the
/// shader skips impacts once the other channels have faded out.
void setTextonRetained(shader::LichenMap& result, const TextonMap& map) {
  const std::array<shader::uvec4*, 3> kept{&result.mipRetained0, &result.mipRetained1,
                                           &result.mipRetained2};
  for (std::size_t c = 0; c < map.scale.size(); ++c)
    if (map.scale[c] > 0.0)
      *kept[c] = retainedAmplitudes(lossRow(map.mipLoss, c, map.scale.size()));
}

/// Mix weight = constant + perUv . uv.
struct LinearWeight {
  double constant = 0.0;
  std::array<double, 2> perUv{};
};

/// The linear weight of MixSource::constant or direction, with uv relative to the placement's tile
/// origin. The origin moves the texture coordinates only for Mapping::uv; for other mappings it is
/// a 3-D position.
LinearWeight linearWeight(const MaterialNoise& material, const Placement& placement) {
  const MixWeight& mix = material.mix;
  if (mix.source == MixSource::constant)
    return {mix.weight, {}};
  if (mix.source != MixSource::direction)
    return {};
  const std::array<double, 2> way{mix.end[0] - mix.start[0], mix.end[1] - mix.start[1]};
  const double squaredLength = way[0] * way[0] + way[1] * way[1];
  LinearWeight weight{0.0, {way[0] / squaredLength, way[1] / squaredLength}};
  // Converts the origin to texture coordinates: the inverse of tile = R(rotation) uv / scale.
  const double cosine = std::cos(material.rotation) * material.scale;
  const double sine = std::sin(material.rotation) * material.scale;
  const bool isMoved = material.mapping == Mapping::uv;
  const double tileX = isMoved ? double(placement.tileOriginX) : 0.0;
  const double tileY = isMoved ? double(placement.tileOriginY) : 0.0;
  weight.constant = weight.perUv[0] * (cosine * tileX - sine * tileY - mix.start[0]) +
                    weight.perUv[1] * (sine * tileX + cosine * tileY - mix.start[1]);
  return weight;
}

/// What of a noise's shape its constants hold.
TextonShape shapeOf(const shader::LichenNoise& noise) {
  const shader::LichenTextonNoise part = partOf<shader::LichenTextonNoise>(noise);
  TextonShape shape;
  shape.coefficientsX = part.coefficientsX;
  shape.coefficientsY = part.coefficientsY;
  shape.order = int(part.order);
  shape.steps = int(part.steps);
  shape.texelsPerTileX = int(noise.tileTexelsX);
  shape.texelsPerTileY = int(noise.tileTexelsY);
  return shape;
}

/// Sets the cubes of surface noise and the amplitude of its impacts.
void setSurface(const TextonShape& shape, const MaterialNoise& material, const Placement& placement,
                shader::LichenMaterial& constants, shader::LichenTextonMaterial& part) {
  const Lattice grid = surfaceGrid(shape, material.impacts);
  constants.columnsPerTile = constants.rowsPerTile = float(grid.columnsPerTile);
  const auto across = impactGridCell(grid, placement.tileOriginX, placement.tileOriginY);
  constants.cellI = across[0];
  constants.cellJ = across[1];
  constants.seedWord = latticeSeed(material.seed, kSurfacePlane);
  part.cellK = impactGridCell(grid, placement.tileOriginZ, 0)[0];
  // [GLM17] proposition 3: the variance of surface noise is lambda r / 3 times the texton's.
  const double cube = shape.texelsPerTileX / grid.columnsPerTile;
  const double lambda = 1.0 / (cube * cube * cube);
  part.surfaceCubeTexels = float(cube);
  part.amplitude = float(1.0 / std::sqrt(lambda * surfaceThickness(shape) / 3.0));
}

bool fits(Mapping mapping) { return mapping != Mapping::solid; }

bool hasSteps(const Noise& noise) { return noise.as<TextonShape>().steps > 1; }

std::array<std::uint32_t, 2> texelsPerTile(const Noise& noise) {
  const auto& shape = noise.as<TextonShape>();
  return {std::uint32_t(shape.texelsPerTileX), std::uint32_t(shape.texelsPerTileY)};
}

Lattice cells(const shader::LichenNoise& noise, const MaterialNoise& material,
              const Placement& placement) {
  return impactGrid(shapeOf(noise), material.impacts, placement);
}

std::array<std::int32_t, 2> cellOf(const shader::LichenNoise& noise, const MaterialNoise& material,
                                   std::int64_t tileX, std::int64_t tileY) {
  return impactGridCell(cells(noise, material, {}), tileX, tileY);
}

void setMap(const Bundle& bundle, const Noise&, const NoiseMap& map, shader::LichenMap& constants) {
  const auto& texton = map.as<TextonMap>();
  setImage(constants, bundle.tables[texton.image]);
  constants.decoding = LICHEN_DECODING_GAUSSIAN;
  setRows(constants, diagonal(texton.scale), map.mean.size(), map.mean);
  constants.sumFactor = {1.0f, 1.0f, 1.0f, 0.0f};
  setTextonRetained(constants, texton);
  setGaussianMean(constants);
}

void setNoise(const Bundle&, const Noise& noise, shader::LichenNoise& constants) {
  const auto& shape = noise.as<TextonShape>();
  setPart(constants, shader::LichenTextonNoise{
                         shape.coefficientsX, shape.coefficientsY, int(shape.frameWidth()),
                         int(shape.frameHeight()), shader::uint(shape.order),
                         shader::uint(shape.mipLevels), shader::uint(shape.steps), 0});
}

void setMaterial(const shader::LichenNoise& noise, const MaterialNoise& material,
                 const Placement& placement, shader::LichenMaterial& constants) {
  const TextonShape shape = shapeOf(noise);
  shader::LichenTextonMaterial part{};
  part.pointProcess = material.pointProcess == PointProcess::poisson ? LICHEN_POINTS_POISSON
                                                                     : LICHEN_POINTS_STRATIFIED;
  if (shape.steps > 1) {
    const LinearWeight weight = linearWeight(material, placement);
    part.mixWeight = float(weight.constant);
    part.mixPerU = float(weight.perUv[0]);
    part.mixPerV = float(weight.perUv[1]);
  }
  if (material.mapping == Mapping::surface) {
    setSurface(shape, material, placement, constants, part);
  } else {
    const Lattice grid = impactGrid(shape, material.impacts, placement);
    const double cellArea =
        shape.texelsPerTileX / grid.columnsPerTile * (shape.texelsPerTileY / grid.rowsPerTile);
    part.amplitude = float(std::sqrt(cellArea));
  }
  setPart(constants, part);
}

std::uint32_t features(const shader::LichenNoise& noise, const MaterialNoise& material) {
  const auto texton = partOf<shader::LichenTextonNoise>(noise);
  return featureIf(texton.order == 3, LICHEN_FEATURE_CUBIC_TEXTONS) |
         featureIf(texton.order == 0, LICHEN_FEATURE_NEAREST_TEXTONS) |
         featureIf(texton.steps > 1, LICHEN_FEATURE_MIXES) |
         featureIf(material.pointProcess == PointProcess::poisson, LICHEN_FEATURE_POISSON_POINTS);
}

} // namespace

extern const MethodParameters kTextonParameters{.fits = fits,
                                                .isMix = hasSteps,
                                                .texelsPerTile = texelsPerTile,
                                                .features = features,
                                                .cells = cells,
                                                .cellOf = cellOf,
                                                .setMap = setMap,
                                                .setNoise = setNoise,
                                                .setMaterial = setMaterial};

} // namespace lichen
