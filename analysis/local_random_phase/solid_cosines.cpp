// SPDX-License-Identifier: MIT
// A point in space and its footprint -> the sum of the cosines around it. Steps and names follow
// shaders_glsl/noise/solid_cosines.glsl.
#include "solid_cosines.h"

#include "cosine.h"
#include "sampling/solid_point.h"
#include "solid_vertices.h"

#include <algorithm>
#include <cmath>

namespace lichen::local_random_phase {
namespace {

using solid::Vec3;

constexpr std::uint32_t kGoldenRatio = 0x9E3779B9u; // its fraction in 2^32nds

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

solid::Sum solidSumAt(std::span<const std::array<CosineTexel, kRowCosines>> texels,
                      const std::vector<int>& octaves, std::uint32_t variants,
                      const shader::LichenNoise& noise, const shader::LichenMap& map,
                      const shader::LichenMaterial& material, const SolidFootprint& at) {
  const Vec3 offset{material.offsetX, material.offsetY, cosinesPart(material).offsetZ};
  const Vec3 position =
      solid::combined(1.0f, offset, 1.0f, solid::inTiles(at.position, material, noise));
  const std::array<Vec3, 2> axes = solid::footprintOf(at, material, noise);
  const SolidCell cell = solidCellAt(material, position);
  solid::Sum sum;
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
      const Vec3 cubes = solid::product(axis, cubesPerTile(material));
      ofWindow += kSolidWindowSpread * float(std::ldexp(solid::dot(cubes, cubes), 2 * int(octave)));
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
        const float z = solid::kMostDepth * std::sqrt(x * x + inSpace * inSpace) * share;
        depths[v] += kGoldenRatio;
        const float turns = solid::dot({x, y, z}, vertex.offset) + draw.phase + amplitude[3];
        const float alongA = solid::dot({x, y, z}, axes[0]),
                    alongB = solid::dot({x, y, z}, axes[1]);
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

} // namespace lichen::local_random_phase
