// SPDX-License-Identifier: MIT
// Point of a surface and footprint -> the box of cubes around the point.
#include "surface_impacts.h"

#include <algorithm>

namespace lichen::texton {
namespace {

float dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Returns a x + b y.
Vec3 combined(float a, const Vec3& x, float b, const Vec3& y) {
  return {a * x[0] + b * y[0], a * x[1] + b * y[1], a * x[2] + b * y[2]};
}

Vec3 normalized(const Vec3& v) { return combined(1.0f / std::sqrt(dot(v, v)), v, 0.0f, v); }

Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Orthonormal axes of the exemplar on the surface: right, down and outward.
struct Frame {
  Vec3 right{}, down{}, outward{};
};

Frame surfaceFrame(const Vec3& normal, const std::array<float, 4>& tangent) {
  Frame frame;
  frame.outward = normalized(normal);
  const Vec3& n = frame.outward;
  const Vec3 given{tangent[0], tangent[1], tangent[2]};
  frame.right = combined(1.0f, given, -dot(given, n), n);
  constexpr float kLeastLength2 = 1e-12f; // as in the shader
  if (dot(frame.right, frame.right) < kLeastLength2)
    frame.right = std::abs(n[2]) < 0.5f ? Vec3{-n[1], n[0], 0.0f} : Vec3{0.0f, -n[2], n[1]};
  frame.right = normalized(frame.right);
  const Vec3 left = cross(n, frame.right);
  frame.down = combined(tangent[3] < 0.0f ? 1.0f : -1.0f, left, 0.0f, left);
  return frame;
}

/// Rotates the frame by the material's rotation.
Frame turned(const Frame& frame, float cosine, float sine) {
  return {combined(cosine, frame.right, sine, frame.down),
          combined(cosine, frame.down, -sine, frame.right), frame.outward};
}

/// Returns the thickness of the layer of impacts that reach a point. [texels]
float thickness(const shader::LichenTextonNoise& texton) {
  const int order = int(texton.order);
  return std::sqrt(float(texton.coefficientsX + order) * float(texton.coefficientsY + order));
}

} // namespace

SurfaceImpacts surfaceImpactsAt(const SurfaceFootprint& at, const shader::LichenMaterial& material,
                                const shader::LichenNoise& noise) {
  const float perScale = std::hypot(material.uvToTileXX, material.uvToTileXY);
  const float tilesPerMetre = perScale / noise.tileSizeMetres;
  const Frame frame = turned(surfaceFrame(at.normal, at.tangent), material.uvToTileXX / perScale,
                             material.uvToTileXY / perScale);
  // Texels are square, so the vertical scale is in tiles of the tile's own height.
  const float perHeight = tilesPerMetre * noise.tileAspect;
  TileFootprint plane;
  plane.dx = {tilesPerMetre * dot(frame.right, at.dx), perHeight * dot(frame.down, at.dx)};
  plane.dy = {tilesPerMetre * dot(frame.right, at.dy), perHeight * dot(frame.down, at.dy)};
  SurfaceImpacts surface;
  surface.impacts = impactsWithin(0.0f, plane, material, noise);
  const float side = textonPart(material).surfaceCubeTexels;
  const float greatestHeight = 0.5f * thickness(textonPart(noise));
  const Vec3 none{};
  surface.axes = {combined(side, frame.right, 0.0f, none), combined(side, frame.down, 0.0f, none),
                  combined(side / greatestHeight, frame.outward, 0.0f, none)};
  const Impacts& impacts = surface.impacts;
  surface.radius = {impacts.radius[0], impacts.radius[1], 1.0f};
  // The centre of the coefficients lies at the impact's position.
  const Vec2 shift{0.5f * float(textonPart(noise).coefficientsX) - impacts.middle[0],
                   0.5f * float(textonPart(noise).coefficientsY) - impacts.middle[1]};
  const std::array<std::int32_t, 3> origin{material.cellI, material.cellJ,
                                           textonPart(material).cellK};
  Vec3 inside{};
  for (std::size_t k = 0; k < 3; ++k) {
    const float grid = at.position[k] * tilesPerMetre * material.columnsPerTile;
    const float cell = std::floor(grid);
    inside[k] = grid - cell;
    // 64 bits, because 2^28 tiles may have 2^46 cubes.
    surface.cell[k] = std::uint32_t(std::int64_t(cell)) + std::uint32_t(origin[k]);
    const float middle = inside[k] + (shift[0] * frame.right[k] + shift[1] * frame.down[k]) / side;
    const float reach = (impacts.radius[0] * std::abs(frame.right[k]) +
                         impacts.radius[1] * std::abs(frame.down[k]) +
                         greatestHeight * std::abs(frame.outward[k])) /
                        side;
    surface.first[k] = int(std::floor(middle - reach));
    surface.last[k] = int(std::floor(middle + reach));
  }
  surface.place = {dot(inside, surface.axes[0]) + shift[0], dot(inside, surface.axes[1]) + shift[1],
                   dot(inside, surface.axes[2])};
  return surface;
}

} // namespace lichen::texton
