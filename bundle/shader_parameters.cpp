// SPDX-License-Identifier: MIT
// Bundle and material -> the shader library's uniform structs, except the members of single
// methods.
#include "methods/method_format.h"

#include <lichen/shader_parameters.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lichen {
namespace {

shader::uint encodingOf(ValueEncoding encoding) {
  switch (encoding) {
  case ValueEncoding::srgb:
    return LICHEN_ENCODING_SRGB;
  case ValueEncoding::linear:
    return LICHEN_ENCODING_LINEAR;
  case ValueEncoding::slope:
    return LICHEN_ENCODING_SLOPE;
  case ValueEncoding::log2:
    return LICHEN_ENCODING_LOG2;
  }
  return LICHEN_ENCODING_SRGB;
}

/// The integer part of an offset in tiles; on a periodic lattice, its whole periods.
double wholePart(double offset, bool periodic, double periodTiles) {
  return periodic ? std::floor(offset / periodTiles) * periodTiles : std::floor(offset);
}

/// A tile origin modulo the period, in [0, period). If the origin is not 0, the period is a whole
/// number.
double reduced(std::int64_t origin, double period) {
  if (origin == 0)
    return 0.0;
  const auto whole = std::int64_t(period);
  return double(((origin % whole) + whole) % whole);
}

/// The position of a tile origin in a periodic lattice.
LatticeOrigin periodicOrigin(const Lattice& lattice, bool isSkewed, const Placement& placement) {
  const double row = reduced(placement.tileOriginY, placement.periodTilesY) * lattice.rowsPerTile;
  const double column =
      reduced(placement.tileOriginX, placement.periodTilesX) * lattice.columnsPerTile -
      (isSkewed ? 0.5 * row : 0.0);
  const float belowOne = std::nextafter(1.0f, 0.0f); // cells are half-open
  return {{int(std::floor(column)), int(std::floor(row))},
          {std::min(float(column - std::floor(column)), belowOne),
           std::min(float(row - std::floor(row)), belowOne)}};
}

/// Sets the method's cells, and the position of the tile origin in them.
void setCells(shader::LichenNoise& result, const Noise& noise, const MaterialNoise& material,
              const Placement& placement) {
  const MethodFormat& format = formatOf(noise);
  const Lattice lattice = format.cells(noise, material, placement);
  result.columnsPerTile = float(lattice.columnsPerTile);
  result.rowsPerTile = float(lattice.rowsPerTile);
  result.periodColumns = lattice.periodColumns;
  result.periodRows = lattice.periodRows;
  result.periodTilesX = float(placement.periodTilesX);
  result.periodTilesY = float(placement.periodTilesY);
  // Moves whole tiles or periods of the offset to the origin, where they are exact, so that floats
  // hold only the rest.
  const double wholeX = wholePart(material.offset[0], placement.periodic, placement.periodTilesX);
  const double wholeY = wholePart(material.offset[1], placement.periodic, placement.periodTilesY);
  result.offsetX = float(material.offset[0] - wholeX);
  result.offsetY = float(material.offset[1] - wholeY);
  const std::int64_t tileX = placement.tileOriginX + std::int64_t(wholeX);
  const std::int64_t tileY = placement.tileOriginY + std::int64_t(wholeY);
  const LatticeOrigin origin = placement.periodic
                                   ? periodicOrigin(lattice, format.hasSkewedRows(), placement)
                                   : format.cellOf(lattice, tileX, tileY);
  result.cellI = origin.cell[0];
  result.cellJ = origin.cell[1];
  result.fractionI = origin.fraction[0];
  result.fractionJ = origin.fraction[1];
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
void setPlanes(shader::LichenNoise& result, const Bundle& bundle, const Noise& noise,
               const MaterialNoise& material, const Placement& placement) {
  const MethodFormat& format = formatOf(noise);
  const Lattice lattice = format.cells(noise, material, {});
  const auto [tileWidth, tileHeight] = format.tileSize(bundle, noise);
  const double aspect = double(tileWidth) / double(tileHeight); // texels are square in space
  const double cosine = std::cos(material.rotation);
  const double sine = std::sin(material.rotation);
  result.columnsPerTile = float(lattice.columnsPerTile);
  result.rowsPerTile = float(lattice.rowsPerTile);
  result.planeSharpness = float(material.planeSharpness);
  result.tileAspect = float(aspect);
  const std::array<shader::LichenPlane*, 3> planes{&result.planeX, &result.planeY, &result.planeZ};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [right, down] = ontoPlane(placement, axis);
    const std::array<double, 2> origin{cosine * right + sine * down,
                                       aspect * (cosine * down - sine * right)};
    std::array<std::int64_t, 2> tile{};
    std::array<float, 2> rest{};
    for (std::size_t k = 0; k < 2; ++k) {
      const double offset = origin[k] - std::floor(origin[k]) + material.offset[k];
      tile[k] = std::int64_t(std::floor(origin[k])) + std::int64_t(std::floor(offset));
      rest[k] = float(offset - std::floor(offset));
    }
    const LatticeOrigin at = format.cellOf(lattice, tile[0], tile[1]);
    *planes[axis] = {at.cell[0],
                     at.cell[1],
                     at.fraction[0],
                     at.fraction[1],
                     rest[0],
                     rest[1],
                     latticeSeed(material.seed, std::uint32_t(axis)),
                     0};
  }
}

} // namespace

shader::LichenMap shaderMap(const Bundle& bundle, const Noise& noise, std::size_t mapIndex) {
  const NoiseMap& map = noise.maps[mapIndex];
  shader::LichenMap result{};
  result.encoding = encodingOf(map.encoding);
  formatOf(noise).setMap(bundle, noise, map, result);
  return result;
}

shader::LichenNoise shaderNoise(const Bundle& bundle, const MaterialNoise& material,
                                const Placement& placement) {
  const Noise& noise = bundle.noises[material.noise];
  shader::LichenNoise result{};
  const double cosine = std::cos(material.rotation) / material.scale;
  const double sine = std::sin(material.rotation) / material.scale;
  result.uvToTileXX = float(cosine);
  result.uvToTileXY = float(sine);
  result.uvToTileYX = float(-sine);
  result.uvToTileYY = float(cosine);
  result.blendSharpness = float(material.blendSharpness);
  result.contrast = float(material.contrast);
  result.maxAnisotropy = float(std::max(1.0, placement.maxAnisotropy));
  result.tileSizeMetres = float(noise.tileSizeMetres);
  result.seedWord = latticeSeed(material.seed, 0);
  result.seed = material.seed;
  if (material.mapping == Mapping::surface)
    formatOf(noise).setSurface(noise, material, placement, result);
  else if (material.mapping == Mapping::triplanar)
    setPlanes(result, bundle, noise, material, placement);
  else
    setCells(result, noise, material, placement);
  formatOf(noise).setNoise(bundle, material, placement, result);
  return result;
}

} // namespace lichen
