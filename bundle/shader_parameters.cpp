// SPDX-License-Identifier: MIT
// Bundle and material -> the shader library's uniform structs, except the members of single
// methods.
#include "methods/method_parameters.h"
#include "methods/split_origin.h"

#include <lichen/layered_noise.h>
#include <lichen/shader_parameters.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace lichen {
namespace {

shader::uint encodingOf(ValueEncoding encoding) {
  switch (encoding) {
  case ValueEncoding::root:
  case ValueEncoding::srgb: // never in a bundle
    return LICHEN_ENCODING_ROOT;
  case ValueEncoding::linear:
    return LICHEN_ENCODING_LINEAR;
  case ValueEncoding::slope:
    return LICHEN_ENCODING_SLOPE;
  case ValueEncoding::log2:
    return LICHEN_ENCODING_LOG2;
  case ValueEncoding::index:
    return LICHEN_ENCODING_INDEX;
  }
  return LICHEN_ENCODING_ROOT;
}

/// A place reduced to one period. [tiles] Unless the origin is 0, the period is a whole number.
float withinPeriod(double offset, std::int64_t origin, double periodTiles) {
  const std::int64_t rest = origin == 0 ? 0 : origin % std::int64_t(periodTiles);
  const double place = offset + double(rest);
  return float(place - std::floor(place / periodTiles) * periodTiles);
}

std::array<std::int64_t, 2> originStep(const shader::LichenNoise& noise,
                                       const MaterialNoise& material) {
  const auto ofMethod = parametersOf(noise).originStep;
  return ofMethod != nullptr ? ofMethod(noise, material) : std::array<std::int64_t, 2>{1, 1};
}

/// Sets the method's cells, and the position of the tile origin in them.
void setCells(shader::LichenMaterial& result, const shader::LichenNoise& noise,
              const MaterialNoise& material, const Placement& placement) {
  const MethodParameters& method = parametersOf(noise);
  const Lattice lattice = method.cells(noise, material, placement);
  result.columnsPerTile = float(lattice.columnsPerTile);
  result.rowsPerTile = float(lattice.rowsPerTile);
  result.periodColumns = lattice.periodColumns;
  result.periodRows = lattice.periodRows;
  result.periodTilesX = float(placement.periodTilesX);
  result.periodTilesY = float(placement.periodTilesY);
  // Moves whole tiles or periods of the offset to the origin, where they are exact, so that floats
  // hold only the rest.
  if (placement.periodic) {
    result.offsetX =
        withinPeriod(material.offset[0], placement.tileOriginX, placement.periodTilesX);
    result.offsetY =
        withinPeriod(material.offset[1], placement.tileOriginY, placement.periodTilesY);
    return;
  }
  const std::array<std::int64_t, 2> step = originStep(noise, material);
  const SplitOrigin x = splitOrigin(placement.tileOriginX, material.offset[0], step[0]);
  const SplitOrigin y = splitOrigin(placement.tileOriginY, material.offset[1], step[1]);
  result.offsetX = x.offset;
  result.offsetY = y.offset;
  const std::array<std::int32_t, 2> cell = method.cellOf(noise, material, x.tile, y.tile);
  result.cellI = cell[0];
  result.cellJ = cell[1];
}

/// A 3-D origin in tiles -> its coordinates to the right and down in the plane perpendicular to an
/// axis.
std::array<double, 2> ontoPlane(const Placement& placement, std::size_t axis) {
  const auto x = double(placement.tileOriginX);
  const auto y = double(placement.tileOriginY);
  const auto z = double(placement.tileOriginZ);
  const std::array<std::array<double, 2>, 3> planes{{{-z, -y}, {x, z}, {x, -y}}};
  return planes[axis];
}

/// Sets the three planes of triplanar noise at the placement's origin. Exact for square, unrotated
/// tiles; otherwise off by 2^-12 tiles at 2^40.
void setPlanes(shader::LichenTriplanarMaterial& planes, const shader::LichenNoise& noise,
               const MaterialNoise& material, const Placement& placement) {
  shader::LichenMaterial& result = planes.material;
  const MethodParameters& method = parametersOf(noise);
  const Lattice lattice = method.cells(noise, material, {});
  const std::array<std::int64_t, 2> step = originStep(noise, material);
  const double aspect = double(noise.tileTexelsX) / double(noise.tileTexelsY); // square texels
  const double cosine = std::cos(material.rotation);
  const double sine = std::sin(material.rotation);
  result.columnsPerTile = float(lattice.columnsPerTile);
  result.rowsPerTile = float(lattice.rowsPerTile);
  result.planeSharpness = float(material.planeSharpness);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [right, down] = ontoPlane(placement, axis);
    const std::array<double, 2> origin{cosine * right + sine * down,
                                       aspect * (cosine * down - sine * right)};
    const SplitOrigin x = splitOrigin(origin[0], material.offset[0], step[0]);
    const SplitOrigin y = splitOrigin(origin[1], material.offset[1], step[1]);
    const std::array<std::int32_t, 2> cell = method.cellOf(noise, material, x.tile, y.tile);
    const std::uint32_t seedWord = latticeSeed(material.seed, std::uint32_t(axis));
    if (axis > 0) {
      (axis == 1 ? planes.planeY : planes.planeZ) = {cell[0],  cell[1], x.offset, y.offset,
                                                     seedWord, 0,       0,        0};
      continue;
    }
    result.cellI = cell[0];
    result.cellJ = cell[1];
    result.offsetX = x.offset;
    result.offsetY = y.offset;
    result.seedWord = seedWord;
  }
}

} // namespace

shader::LichenMap shaderMap(const Bundle& bundle, const Noise& noise, std::size_t mapIndex) {
  const NoiseMap& map = noise.maps[mapIndex];
  shader::LichenMap result{};
  result.encoding = encodingOf(map.encoding);
  for (const MapChannel channel : map.channels)
    if (channel >= MapChannel::occlusion && channel <= MapChannel::metallic)
      result.ormChannels |= 1u << (int(channel) - int(MapChannel::occlusion));
  parametersOf(noise).setMap(bundle, noise, map, result);
  return result;
}

std::uint32_t roleOf(MapTarget target) {
  static_assert(int(MapTarget::baseColor) == LICHEN_BASE_COLOR);
  static_assert(int(MapTarget::opacity) == LICHEN_OPACITY);
  return std::uint32_t(target); // the numbers are the same
}

shader::LichenNoise shaderNoise(const Bundle& bundle, std::size_t noiseIndex) {
  const Noise& noise = bundle.noises[noiseIndex];
  const MethodParameters& method = parametersOf(noise);
  const auto [width, height] = tileSize(bundle, noise);
  shader::LichenNoise result{};
  result.tileTexelsX = float(width);
  result.tileTexelsY = float(height);
  result.tileAspect = float(double(width) / double(height));
  result.tileSizeMetres = float(noise.tileSizeMetres);
  result.method = shader::uint(noise.method());
  for (const NoiseMap& map : noise.maps)
    result.roles |= 1u << roleOf(map.target);
  method.setNoise(bundle, noise, result);
  return result;
}

namespace {

void setLayers(const Bundle& bundle, const Noise& noise, shader::LichenNoiseConstants& result) {
  const NoiseLayers& layers = *noise.layers;
  result.layers = shaderLayers(noise);
  for (std::size_t layer = 1; layer <= layers.others.size(); ++layer) {
    const std::size_t index = layers.others[layer - 1];
    const Noise& other = bundle.noises[index];
    result.layerNoises[layer - 1] = shaderNoise(bundle, index);
    for (std::size_t map = 0; map < other.maps.size(); ++map)
      result.maps[layerSlot(layer, roleOf(other.maps[map].target))] = shaderMap(bundle, other, map);
  }
  for (std::size_t n = 0; n < layers.nodes.size(); ++n) {
    const std::size_t index = layers.nodes[n].index;
    result.indexNoises[n] = shaderNoise(bundle, index);
    result.indexMaps[n] = shaderMap(bundle, asIndex(bundle.noises[index]), 0);
  }
}

/// A seed for part `part` of a layered noise: multiples of 2^32 over the golden ratio.
std::uint32_t seedOf(std::uint32_t seed, std::size_t part) {
  constexpr std::uint32_t kGolden = 0x9E3779B9u;
  return seed + kGolden * std::uint32_t(part);
}

} // namespace

shader::LichenNoiseConstants shaderConstants(const Bundle& bundle, std::size_t noiseIndex) {
  const Noise& noise = bundle.noises[noiseIndex];
  shader::LichenNoiseConstants result{};
  result.noise = shaderNoise(bundle, noiseIndex);
  for (std::size_t map = 0; map < noise.maps.size(); ++map)
    result.maps[roleOf(noise.maps[map].target)] = shaderMap(bundle, noise, map);
  if (const auto setConstants = parametersOf(noise).setConstants; setConstants != nullptr)
    setConstants(noise, result);
  if (noise.layers)
    setLayers(bundle, noise, result);
  return result;
}

shader::LichenTriplanarMaterial shaderMaterial(const shader::LichenNoise& noise,
                                               const MaterialNoise& material,
                                               const Placement& placement) {
  const MethodParameters& method = parametersOf(noise);
  shader::LichenTriplanarMaterial planes{};
  shader::LichenMaterial& result = planes.material;
  const double cosine = std::cos(material.rotation) / material.scale;
  const double sine = std::sin(material.rotation) / material.scale;
  result.uvToTileXX = float(cosine);
  result.uvToTileXY = float(sine);
  result.uvToTileYX = float(-sine);
  result.uvToTileYY = float(cosine);
  result.contrast = float(material.contrast);
  result.maxAnisotropy = float(std::max(1.0, placement.maxAnisotropy));
  result.seedWord = latticeSeed(material.seed, 0);
  result.mapping = LICHEN_FEATURE_UV << unsigned(material.mapping);
  result.noise = shader::uint(material.noise);
  if (material.mapping == Mapping::triplanar)
    setPlanes(planes, noise, material, placement);
  else if (material.mapping == Mapping::uv)
    setCells(result, noise, material, placement);
  if (method.setMaterial != nullptr)
    method.setMaterial(noise, material, placement, result);
  return planes;
}

MaterialNoise layerMaterial(const MaterialNoise& material, std::size_t layer) {
  MaterialNoise result = material;
  result.seed = seedOf(material.seed, layer);
  return result;
}

MaterialNoise indexMaterial(const MaterialNoise& material, std::size_t node) {
  MaterialNoise result = layerMaterial(material, LICHEN_MAX_LAYERS + node);
  result.contrast = 1.0;
  return result;
}

shader::LichenLayeredMaterial shaderLayeredMaterial(std::span<const shader::LichenNoise> layers,
                                                    std::span<const shader::LichenNoise> indices,
                                                    const MaterialNoise& material,
                                                    const Placement& placement) {
  shader::LichenLayeredMaterial result{};
  result.first = shaderMaterial(layers.front(), material, placement);
  for (std::size_t layer = 1; layer < layers.size(); ++layer)
    result.layers[layer - 1] =
        shaderMaterial(layers[layer], layerMaterial(material, layer), placement);
  for (std::size_t node = 0; node < indices.size(); ++node)
    result.indices[node] = shaderMaterial(indices[node], indexMaterial(material, node), placement);
  return result;
}

shader::LichenTriplanarMaterial shaderMaterial(const Bundle& bundle, const MaterialNoise& material,
                                               const Placement& placement) {
  return shaderMaterial(shaderNoise(bundle, material.noise), material, placement);
}

} // namespace lichen
