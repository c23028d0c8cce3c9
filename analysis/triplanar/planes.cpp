// SPDX-License-Identifier: MIT
// Point, footprint and normal -> the three planes of triplanar noise at the point.
#include "planes.h"

#include <algorithm>
#include <cmath>

namespace lichen::triplanar {
namespace {

using Vec2 = std::array<float, 2>;
using Vec3 = std::array<float, 3>;

/// For each plane, the right and down directions seen from the end of its axis, as defined in
/// docs/gltf_extension/README.md.
constexpr std::array<std::array<Vec3, 2>, 3> kFrames{
    {{{{0, 0, -1}, {0, -1, 0}}}, {{{1, 0, 0}, {0, 0, 1}}}, {{{1, 0, 0}, {0, -1, 0}}}}};

float dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Returns the weights of the planes; the sum of their squares is 1.
Vec3 weightsOf(const Vec3& normal, float sharpness) {
  constexpr float kLeastWeight = 1.0f / 64.0f; // LICHEN_LEAST_PLANE_WEIGHT
  const float most = std::max({std::abs(normal[0]), std::abs(normal[1]), std::abs(normal[2])});
  Vec3 weights{};
  for (std::size_t k = 0; k < 3; ++k)
    weights[k] = std::max(std::pow(std::abs(normal[k]) / most, sharpness) - kLeastWeight, 0.0f);
  const float norm = std::sqrt(dot(weights, weights));
  for (float& weight : weights)
    weight /= norm;
  return weights;
}

} // namespace

std::array<Plane, 3> planesAt(const TriplanarFootprint& at,
                              const shader::LichenTriplanarMaterial& material,
                              const shader::LichenNoise& noise) {
  const shader::LichenMaterial& own = material.material;
  const Vec3 weights = weightsOf(at.normal, own.planeSharpness);
  const float scale = std::hypot(own.uvToTileXX, own.uvToTileXY);
  const float cosine = own.uvToTileXX / scale;
  const float sine = own.uvToTileXY / scale;
  const float tilesPerMetre = scale / noise.tileSizeMetres;
  std::array<Plane, 3> planes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Plane& plane = planes[axis];
    const auto& [right, down] = kFrames[axis];
    Vec3 exemplarRight{}, exemplarDown{};
    for (std::size_t k = 0; k < 3; ++k) {
      exemplarRight[k] = cosine * right[k] + sine * down[k];
      exemplarDown[k] = cosine * down[k] - sine * right[k];
      plane.axes[0][k] = exemplarRight[k];
      plane.axes[1][k] = -exemplarDown[k];
    }
    // Texels are square in space.
    const auto tiles = [&](const Vec3& way) {
      return Vec2{tilesPerMetre * dot(way, exemplarRight),
                  tilesPerMetre * noise.tileAspect * dot(way, exemplarDown)};
    };
    plane.weight = weights[axis];
    plane.material = own;
    if (axis > 0) {
      const shader::LichenPlane& origin = axis == 1 ? material.planeY : material.planeZ;
      plane.material.cellI = origin.cellI;
      plane.material.cellJ = origin.cellJ;
      plane.material.offsetX = origin.offsetX;
      plane.material.offsetY = origin.offsetY;
      plane.material.seedWord = origin.seedWord;
    }
    plane.at = {tiles(at.position), tiles(at.dx), tiles(at.dy)};
    const float squaredCosine = at.normal[axis] * at.normal[axis] / dot(at.normal, at.normal);
    plane.seen = 0.5f + 0.5f * squaredCosine;
  }
  return planes;
}

} // namespace lichen::triplanar
