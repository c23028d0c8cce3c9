// SPDX-License-Identifier: MIT
// A point in space and its footprint -> the sum of the cosines around it. Steps and names follow
// shaders_glsl/noise/solid_cosines.glsl.
#include "solid_cosines.h"

#include "cosine.h"
#include "solid_vertices.h"

#include <algorithm>
#include <cmath>

namespace lichen::local_random_phase {
namespace {

using Vec3 = std::array<float, 3>;

/// The largest third frequency of a solid over the length of the two of the exemplar.
constexpr float kMostDepth = 1.2f;
constexpr std::uint32_t kGoldenRatio = 0x9E3779B9u; // its fraction in 2^32nds

float dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec3 combined(float a, const Vec3& x, float b, const Vec3& y) {
  return {a * x[0] + b * y[0], a * x[1] + b * y[1], a * x[2] + b * y[2]};
}
Vec3 product(const Vec3& a, const Vec3& b) { return {a[0] * b[0], a[1] * b[1], a[2] * b[2]}; }

/// Metres in space -> tiles, of a vector: the exemplar lies as on the plane that looks along z.
Vec3 inTiles(const Vec3& metres, const shader::LichenMaterial& material,
             const shader::LichenNoise& noise) {
  const float perScale = std::hypot(material.uvToTileXX, material.uvToTileXY);
  const float right = material.uvToTileXX * metres[0] - material.uvToTileXY * metres[1];
  const float down = material.uvToTileYX * metres[0] - material.uvToTileYY * metres[1];
  return {right / noise.tileSizeMetres, noise.tileAspect * down / noise.tileSizeMetres,
          perScale * metres[2] / noise.tileSizeMetres};
}

/// lichenSolidPointAt: axes of the footprint [tiles], less what a texel averages along each.
std::array<Vec3, 2> footprintOf(const Vec3& gradientX, const Vec3& gradientY,
                                const shader::LichenNoise& noise) {
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

/// The slope of one wave along z. The gradient of a wave points along its frequency, so its slopes
/// along x and y give the one along z.
float depthSlopeOf(const Vec3& frequency, const CosineTexel& amplitude,
                   const shader::LichenMap& map) {
  const float slopeX = map.row0.x * amplitude[0] + map.row0.y * amplitude[1];
  const float slopeY = map.row1.x * amplitude[0] + map.row1.y * amplitude[1];
  constexpr float kLeast = 1e-20f;
  const float square = frequency[0] * frequency[0] + frequency[1] * frequency[1];
  return frequency[2] * (frequency[0] * slopeX - frequency[1] * slopeY) / std::max(square, kLeast);
}

} // namespace

SolidSum solidSumAt(std::span<const std::array<CosineTexel, kRowCosines>> texels,
                    const std::vector<int>& octaves, std::uint32_t variants,
                    const shader::LichenNoise& noise, const shader::LichenMap& map,
                    const shader::LichenMaterial& material, const SolidFootprint& at) {
  const Vec3 offset{material.offsetX, material.offsetY, cosinesPart(material).offsetZ};
  const Vec3 position = combined(1.0f, offset, 1.0f, inTiles(at.position, material, noise));
  const std::array<Vec3, 2> axes =
      footprintOf(inTiles(at.dx, material, noise), inTiles(at.dy, material, noise), noise);
  const SolidCell cell = solidCellAt(material, position);
  SolidSum sum;
  const auto* row = texels.data();
  for (std::size_t octave = 0; octave < octaves.size(); ++octave) {
    if (octaves[octave] == 0)
      continue;
    std::array<SolidVertex, 4> vertices = solidVerticesAt(cell, int(octave), material);
    std::array<std::uint32_t, 4> columns{};
    for (std::size_t v = 0; v < vertices.size(); ++v)
      columns[v] = kCosineColumns + variantOf(vertices[v].state, variants);
    float ofWindow = 0.0f;
    for (const Vec3& axis : axes) {
      const Vec3 cubes = product(axis, cubesPerTile(material));
      ofWindow += kSolidWindowSpread * float(std::ldexp(dot(cubes, cubes), 2 * int(octave)));
    }
    std::array<std::uint32_t, 4> depths{}; // low bits, as the variant has the high ones
    for (std::size_t v = 0; v < vertices.size(); ++v)
      depths[v] = vertices[v].state << 7u;
    for (int k = 0; k < octaves[octave]; ++k) {
      const std::size_t own = std::size_t(k) % kRowCosines;
      const CosineTexel& box = row[0][own];
      for (std::size_t v = 0; v < vertices.size(); ++v) {
        SolidVertex& vertex = vertices[v];
        const CosineTexel& amplitude = row[columns[v]][own];
        const Draw draw = nextDraw(vertex.state);
        const float x = box[0] + box[2] * draw.column, y = box[1] + box[3] * draw.row;
        const float inSpace = noise.tileAspect * y;
        const float share = float(std::int32_t(depths[v])) * 0x1p-31f;
        const float z = kMostDepth * std::sqrt(x * x + inSpace * inSpace) * share;
        depths[v] += kGoldenRatio;
        const float turns = dot({x, y, z}, vertex.offset) + draw.phase + amplitude[3];
        const float alongA = dot({x, y, z}, axes[0]), alongB = dot({x, y, z}, axes[1]);
        const float window =
            vertex.weight * retainedAt(ofWindow + alongA * alongA + alongB * alongB);
        const float value = window * cosineOfTurns(turns);
        for (std::size_t c = 0; c < 3; ++c) {
          sum.gaussian[c] += value * amplitude[c];
          const float square = amplitude[c] * amplitude[c];
          sum.squares += vertex.weight * vertex.weight * square;
          sum.lost += (vertex.weight * vertex.weight - window * window) * square;
        }
        if (map.encoding == LICHEN_ENCODING_SLOPE)
          sum.depthSlope += value * depthSlopeOf({x, inSpace, z}, amplitude, map);
      }
      if (own + 1 == kRowCosines)
        row += kCosineColumns + variants;
    }
  }
  return sum;
}

std::array<float, 4> slopesInSpace(const std::array<float, 4>& slopes, float depthSlope,
                                   const shader::LichenMaterial& material) {
  const float length = std::hypot(material.uvToTileXX, material.uvToTileXY);
  const float cosine = material.uvToTileXX / length, sine = material.uvToTileXY / length;
  return {cosine * slopes[0] + sine * slopes[1], cosine * slopes[1] - sine * slopes[0],
          material.contrast * depthSlope, slopes[2]};
}

} // namespace lichen::local_random_phase
