// SPDX-License-Identifier: MIT
// Point of a surface and footprint -> its frame, and the box of cubes around the point.
#include "surface_cubes.h"

namespace lichen::surface {
namespace {

using space::combined;
using space::cross;
using space::dot;
using space::scaled;

Vec3 normalized(const Vec3& v) { return scaled(1.0f / std::sqrt(dot(v, v)), v); }

/// lichenSurfaceFrame: to the right and down in the exemplar, and outward.
std::array<Vec3, 3> frameOf(const Vec3& normal, const std::array<float, 4>& tangent) {
  const Vec3 outward = normalized(normal);
  const Vec3 given{tangent[0], tangent[1], tangent[2]};
  Vec3 right = combined(1.0f, given, -dot(given, outward), outward);
  constexpr float kLeastLength2 = 1e-12f; // as in the shader
  if (dot(right, right) < kLeastLength2)
    right = std::abs(outward[2]) < 0.5f ? Vec3{-outward[1], outward[0], 0.0f}
                                        : Vec3{0.0f, -outward[2], outward[1]};
  right = normalized(right);
  return {right, scaled(tangent[3] < 0.0f ? 1.0f : -1.0f, cross(outward, right)), outward};
}

} // namespace

Point pointAt(const SurfaceFootprint& at, const shader::LichenMaterial& material,
              const shader::LichenNoise& noise) {
  const float perScale = std::hypot(material.uvToTileXX, material.uvToTileXY);
  const float cosine = material.uvToTileXX / perScale, sine = material.uvToTileXY / perScale;
  const float tilesPerMetre = perScale / noise.tileSizeMetres;
  const auto [right, down, outward] = frameOf(at.normal, at.tangent);
  Point point;
  point.right = combined(cosine, right, sine, down);
  point.down = combined(cosine, down, -sine, right);
  point.outward = outward;
  point.position = scaled(tilesPerMetre, at.position);
  // Texels are square, so the vertical scale is in tiles of the tile's own height.
  const float perHeight = tilesPerMetre * noise.tileAspect;
  point.plane.dx = {tilesPerMetre * dot(point.right, at.dx), perHeight * dot(point.down, at.dx)};
  point.plane.dy = {tilesPerMetre * dot(point.right, at.dy), perHeight * dot(point.down, at.dy)};
  return point;
}

void place(Cubes& cubes, const Vec3& inside, const Vec3& shift) {
  // The inverse of the axes, by Cramer's rule: the cubes along which each offset alone changes.
  const auto& axes = cubes.axes;
  const Vec3 normal = cross(axes[1], axes[2]);
  const float perVolume = 1.0f / dot(axes[0], normal);
  const std::array<Vec3, 3> alone{scaled(perVolume, normal),
                                  scaled(perVolume, cross(axes[2], axes[0])),
                                  scaled(perVolume, cross(axes[0], axes[1]))};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    float middle = inside[axis], reach = 0.0f;
    for (std::size_t k = 0; k < 3; ++k) {
      middle += shift[k] * alone[k][axis];
      reach += cubes.radius[k] * std::abs(alone[k][axis]);
    }
    cubes.first[axis] = int(std::floor(middle - reach));
    cubes.last[axis] = int(std::floor(middle + reach));
  }
  for (std::size_t k = 0; k < 3; ++k)
    cubes.place[k] = dot(inside, axes[k]) + shift[k];
}

} // namespace lichen::surface
