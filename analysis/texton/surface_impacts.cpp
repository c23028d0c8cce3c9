// SPDX-License-Identifier: MIT
// Point of a surface and footprint -> the cubes around the point.
#include "surface_impacts.h"

#include <cstddef>

namespace lichen::texton {
namespace {

/// Returns the thickness of the layer of impacts that reach a point. [texels]
float thickness(const shader::LichenTextonNoise& texton) {
  const int order = int(texton.order);
  return std::sqrt(float(texton.coefficientsX + order) * float(texton.coefficientsY + order));
}

} // namespace

SurfaceImpacts surfaceImpactsAt(const SurfaceFootprint& at, const shader::LichenMaterial& material,
                                const shader::LichenNoise& noise) {
  const surface::Point point = surface::pointAt(at, material, noise);
  const shader::LichenTextonMaterial own = textonPart(material);
  const shader::LichenTextonNoise shape = textonPart(noise);
  SurfaceImpacts result;
  result.impacts = impactsWithin(0.0f, point.plane, material, noise);
  const Impacts& impacts = result.impacts;
  const float side = own.surfaceCubeTexels;
  surface::Cubes& cubes = result.cubes;
  cubes.axes = {space::scaled(side, point.right), space::scaled(side, point.down),
                space::scaled(side / (0.5f * thickness(shape)), point.outward)};
  cubes.radius = {impacts.radius[0], impacts.radius[1], 1.0f};
  cubes.seed = material.seedWord;
  cubes.isPoisson = own.pointProcess == LICHEN_POINTS_POISSON;
  const std::array<std::int32_t, 3> origin{material.cellI, material.cellJ, own.cellK};
  surface::Vec3 inside{};
  for (std::size_t k = 0; k < 3; ++k) {
    const float grid = point.position[k] * material.columnsPerTile;
    const float cell = std::floor(grid);
    inside[k] = grid - cell;
    // 64 bits, because 2^28 tiles may have 2^46 cubes.
    cubes.cell[k] = std::uint32_t(std::int64_t(cell)) + std::uint32_t(origin[k]);
  }
  // The centre of the coefficients lies at the impact's position.
  surface::place(cubes, inside,
                 {0.5f * float(shape.coefficientsX) - impacts.middle[0],
                  0.5f * float(shape.coefficientsY) - impacts.middle[1], 0.0f});
  return result;
}

} // namespace lichen::texton
