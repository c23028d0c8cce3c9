// SPDX-License-Identifier: MIT
// Metres -> the space of tiles, and sums over waves -> values. Steps and names follow
// shaders_glsl/noise/solid_footprint.glsl and solid_method.glsl.
#include "solid_point.h"

#include "wave.h"

#include <algorithm>
#include <cmath>

namespace lichen::solid {

Vec3 product(const Vec3& a, const Vec3& b) { return {a[0] * b[0], a[1] * b[1], a[2] * b[2]}; }

Vec3 inTiles(const Vec3& metres, const shader::LichenMaterial& material,
             const shader::LichenNoise& noise) {
  const float perScale = std::hypot(material.uvToTileXX, material.uvToTileXY);
  const float right = material.uvToTileXX * metres[0] - material.uvToTileXY * metres[1];
  const float down = material.uvToTileYX * metres[0] - material.uvToTileYY * metres[1];
  return {right / noise.tileSizeMetres, noise.tileAspect * down / noise.tileSizeMetres,
          perScale * metres[2] / noise.tileSizeMetres};
}

std::array<Vec3, 2> footprintOf(const SolidFootprint& at, const shader::LichenMaterial& material,
                                const shader::LichenNoise& noise) {
  const Vec3 gradientX = inTiles(at.dx, material, noise);
  const Vec3 gradientY = inTiles(at.dy, material, noise);
  const Vec3 texels{noise.tileTexelsX, noise.tileTexelsY, noise.tileTexelsX};
  const Vec3 x = product(texels, gradientX), y = product(texels, gradientY);
  const float xx = dot(x, x), yy = dot(y, y), xy = dot(x, y);
  const float mean = 0.5f * (xx + yy), half = 0.5f * (xx - yy);
  const float apart = std::sqrt(half * half + xy * xy);
  constexpr float kLeast = 1e-20f; // of a circle, whose axes are the same
  const auto kept = [&](float squared) {
    return std::sqrt(beyondTexel(squared) / std::max(squared, kLeast));
  };
  const float longer = kept(mean + apart), shorter = kept(mean - apart);
  const float slope = 0.5f * (longer - shorter) / std::max(apart, kLeast);
  const float middle = 0.5f * (longer + shorter);
  return {combined(middle + slope * half, gradientX, slope * xy, gradientY),
          combined(slope * xy, gradientX, middle - slope * half, gradientY)};
}

std::array<float, 4> gaussianOf(const Sum& sum, const shader::LichenMaterial& material) {
  constexpr float kLeast = 1e-20f; // of a map that does not vary
  return {0.5f + material.contrast * sum.gaussian[0], 0.5f + material.contrast * sum.gaussian[1],
          0.5f + material.contrast * sum.gaussian[2], sum.lost / std::max(sum.squares, kLeast)};
}

std::array<float, 4> valueOf(const Sum& sum, const gaussianization::ValueDecoder& decoder,
                             const shader::LichenMaterial& material) {
  const std::array<float, 4> value = decoder.decode(gaussianOf(sum, material), material.contrast);
  if (decoder.constants().encoding != LICHEN_ENCODING_SLOPE)
    return value;
  const float length = std::hypot(material.uvToTileXX, material.uvToTileXY);
  const float cosine = material.uvToTileXX / length, sine = material.uvToTileXY / length;
  return {cosine * value[0] + sine * value[1], cosine * value[1] - sine * value[0],
          material.contrast * sum.depthSlope, value[2]};
}

} // namespace lichen::solid
