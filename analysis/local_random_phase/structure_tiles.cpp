// SPDX-License-Identifier: MIT
// Image of cosines -> the levels of its structure; a point -> tiles of it, blended. Steps and names
// follow shaders_glsl/noise/structure.glsl.
#include "structure_tiles.h"

#include "octave_lattice.h"
#include "sampling/footprint_level.h"

#include <lichen/structure_texel.h>

#include <algorithm>
#include <cmath>

namespace lichen::local_random_phase {
namespace {

/// The level's texels, from the column `column` of the image on.
std::vector<std::array<float, 3>> decodedLevel(const std::vector<float>& image,
                                               const CosineImageLayout& layout,
                                               const CosineStructure& structure, int level,
                                               std::uint32_t column,
                                               const shader::vec4& perInteger) {
  const std::size_t columns = std::size_t(structure.columns) >> level;
  const std::size_t rows = std::size_t(structure.rows) >> level;
  const std::array<std::uint32_t, 2> corner = layout.levelCorner(level);
  std::vector<std::array<float, 3>> texels;
  texels.reserve(columns * rows);
  for (std::size_t y = 0; y < rows; ++y)
    for (std::size_t x = 0; x < columns; ++x) {
      const std::size_t texel = (corner[1] + y / 2) * layout.width + corner[0] + column + x / 2;
      const auto integers = fromStructureTexel(image[4 * texel + 2 * (y % 2) + x % 2]);
      texels.push_back({perInteger.x * float(integers[0]), perInteger.y * float(integers[1]),
                        perInteger.z * float(integers[2])});
    }
  return texels;
}

/// lichenSplineWeights
std::array<float, 4> splineWeights(float t) {
  const float left = 1.0f - t;
  std::array<float, 4> weights{left * left * left, 4.0f + t * t * (3.0f * t - 6.0f), 0.0f,
                               t * t * t};
  weights[2] = 6.0f - weights[0] - weights[1] - weights[3];
  for (float& weight : weights)
    weight /= 6.0f;
  return weights;
}

/// lichenTurbulence
std::array<float, 2> turbulenceAt(const std::array<CosineVertex, 3>& vertices) {
  constexpr float kPerBit = 3.4641016f * 0x1p-32f; // of signed integers, which have 1 / sqrt(12)
  std::array<float, 2> displacement{};
  for (const CosineVertex& vertex : vertices) {
    const std::uint32_t state = vertex.state * 747796405u + 2891336453u;
    displacement[0] += kPerBit * vertex.weight * float(std::int32_t(state << 11u));
    displacement[1] += kPerBit * vertex.weight * float(std::int32_t(state));
  }
  return displacement;
}

} // namespace

StructureTiles::StructureTiles(const CosineStructure& structure, const CosineImageLayout& layout,
                               const std::vector<float>& image, const LocalRandomPhaseMap& map,
                               const shader::LichenMap& constants)
    : structure_(structure), dimensions_(float(map.dimensions)),
      turbulence_(float(std::lround(structure.turbulence * 0xFFFF)) / 65535.0f) {
  const auto byteOf = [&](int level) {
    const std::array words{constants.mipRetained0.x, constants.mipRetained0.y,
                           constants.mipRetained0.z, constants.mipRetained0.w};
    const auto byte = unsigned(std::min(level, LICHEN_MAX_MIPS - 1));
    return float(words[byte / 4] >> (8u * (byte % 4u)) & 255u) / 255.0f;
  };
  for (int level = 0; level < structureLevels(structure); ++level) {
    levels_.push_back(decodedLevel(image, layout, structure, level, 0, constants.sumFactor));
    if (structure.offsets > 0)
      means_.push_back(
          decodedLevel(image, layout, structure, level, layout.meanColumn, constants.sumFactor));
    deviations_.push_back(byteOf(level));
  }
  deviations_.push_back(byteOf(structureLevels(structure)));
  const float* list = image.data() + 4 * std::size_t(layout.offsetRow) * layout.width;
  for (int k = 0; k < structure.offsets; ++k)
    offsets_.push_back({list[2 * k], list[2 * k + 1]});
}

std::array<float, 3> StructureTiles::splineAt(const std::vector<Texels>& levels, int level,
                                              const Vec2& place) const {
  const Texels& texels = levels[std::size_t(level)];
  const int columns = structure_.columns >> level, rows = structure_.rows >> level;
  const float x = place[0] * float(columns) - 0.5f, y = place[1] * float(rows) - 0.5f;
  const float left = std::floor(x), top = std::floor(y);
  const std::array<float, 4> across = splineWeights(x - left), down = splineWeights(y - top);
  std::array<float, 3> sum{};
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      const int column = (int(left) - 1 + i) & (columns - 1), row = (int(top) - 1 + j) & (rows - 1);
      const auto& texel = texels[std::size_t(row) * std::size_t(columns) + std::size_t(column)];
      for (std::size_t c = 0; c < 3; ++c)
        sum[c] += across[std::size_t(i)] * down[std::size_t(j)] * texel[c];
    }
  return sum;
}

StructureTiles::Value StructureTiles::at(const CosineCell& cell,
                                         const shader::LichenMaterial& material,
                                         const TileFootprint& footprint) const {
  Value value;
  if (levels_.empty())
    return value;
  const int levels = int(levels_.size());
  const float level = std::min(
      footprintLevel(footprint, float(structure_.columns), float(structure_.rows)), float(levels));
  const int finer = int(level);
  const float coarserShare = level - float(finer);
  const std::array<CosineVertex, 3> vertices =
      verticesAt(cell, kPlacementOctave, LICHEN_MAX_OCTAVES, material);
  const Vec2 turbulence = turbulenceAt(vertices);
  const auto add = [&](const std::vector<Texels>& image, Vec2 place, float weight) {
    for (std::size_t axis = 0; axis < 2; ++axis)
      place[axis] += turbulence_ * turbulence[axis];
    for (int k = finer; k < std::min(finer + 2, levels); ++k) {
      const float share = k == finer ? 1.0f - coarserShare : coarserShare;
      if (share == 0.0f)
        continue;
      const std::array<float, 3> texel = splineAt(image, k, place);
      for (std::size_t c = 0; c < 3; ++c)
        value.gaussian[c] += weight * share * texel[c];
    }
  };
  const bool isGuided = !offsets_.empty() && cosinesPart(material).guided != 0;
  Vec2 position{footprint.position[0] + material.offsetX, footprint.position[1] + material.offsetY};
  for (float& axis : position)
    axis -= std::floor(axis);
  float sumOfWeights = 0.0f;
  for (const CosineVertex& vertex : vertices) {
    Vec2 place = vertex.offset;
    if (isGuided) {
      const auto count = (std::uint32_t(offsets_.size()) - vertex.color + 2u) / 3u;
      const std::uint32_t index = 3u * ((vertex.state >> 16u) * count >> 16u) + vertex.color;
      place = {position[0] + offsets_[index][0], position[1] + offsets_[index][1]};
    } else {
      place[0] += float(vertex.state & 0xFFFFu) / 65536.0f;
      place[1] += float(vertex.state >> 16u) / 65536.0f;
    }
    add(levels_, place, vertex.weight);
    sumOfWeights += vertex.weight;
  }
  if (isGuided)
    add(means_, position, 1.0f - sumOfWeights);
  const auto deviationOf = [&](int k) { return deviations_[std::size_t(std::min(k, levels))]; };
  const float whole = deviations_.front();
  const float left =
      (1.0f - coarserShare) * deviationOf(finer) + coarserShare * deviationOf(finer + 1);
  constexpr float kTwiceVariance = 2.0f / 36.0f; // of a channel of the noise
  value.squares = dimensions_ * kTwiceVariance * whole * whole;
  value.lost = dimensions_ * kTwiceVariance * (whole * whole - left * left);
  return value;
}

} // namespace lichen::local_random_phase
