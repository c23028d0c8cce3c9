// SPDX-License-Identifier: MIT
// A cell and footprint -> derivatives of the cosines' sum. Steps and names follow
// shaders_glsl/noise/cosine_gradient.glsl.
#include "cosine_gradient.h"

#include "cosine.h"

#include <algorithm>
#include <cmath>

namespace lichen::local_random_phase {
namespace {

using Vec2 = std::array<float, 2>;
using Vec3 = std::array<float, 3>;

/// Derivatives of the three normalised windows along x and y [1 / tile].
std::array<Vec2, 3> windowSlopes(const std::array<CosineVertex, 3>& vertices,
                                 const Vec2& cellsPerTile) {
  std::array<Vec2, 3> slopes{};
  float squares = 0.0f;
  for (std::size_t v = 0; v < 3; ++v) {
    const float row = vertices[v].offset[1] * cellsPerTile[1];
    const float column = vertices[v].offset[0] * cellsPerTile[0] - 0.5f * row;
    constexpr float kPerSquaredRadius = 4.0f / 3.0f; // as windowAt()
    const float square = column * column + column * row + row * row;
    const float left = std::max(1.0f - kPerSquaredRadius * square, 0.0f);
    squares += std::pow(left, 6.0f);
    const float slope = -3.0f * kPerSquaredRadius * left * left; // per squared distance
    const float alongColumns = slope * (2.0f * column + row);
    const float alongRows = slope * (column + 2.0f * row);
    slopes[v] = {cellsPerTile[0] * alongColumns,
                 cellsPerTile[1] * (alongRows - 0.5f * alongColumns)};
  }
  // The squares of the windows sum to 1 everywhere.
  for (std::size_t axis = 0; axis < 2; ++axis) {
    float common = 0.0f;
    for (std::size_t v = 0; v < 3; ++v) {
      slopes[v][axis] /= std::sqrt(squares);
      common += vertices[v].weight * slopes[v][axis];
    }
    for (std::size_t v = 0; v < 3; ++v)
      slopes[v][axis] -= vertices[v].weight * common;
  }
  return slopes;
}

} // namespace

CosineSlopes cosineSlopesAt(std::span<const std::array<CosineTexel, kRowCosines>> texels,
                            const std::vector<int>& octaves, std::uint32_t variants,
                            const CosineCell& cell, const WaveFootprint& footprint,
                            const shader::LichenMaterial& material) {
  CosineSlopes slopes;
  const auto* row = texels.data();
  for (std::size_t octave = 0; octave < octaves.size(); ++octave) {
    if (octaves[octave] == 0)
      continue;
    std::array<CosineVertex, 3> vertices =
        verticesAt(cell, int(octave), std::uint32_t(octave), material);
    std::array<std::uint32_t, 3> columns{};
    for (std::size_t v = 0; v < 3; ++v)
      columns[v] = kCosineColumns + variantOf(vertices[v].state, variants);
    const float ofWindow = squaredCyclesOfWindow(footprint, int(octave), material);
    std::array<Vec3, 3> sums{};
    for (int k = 0; k < octaves[octave]; ++k) {
      const std::size_t own = std::size_t(k) % kRowCosines;
      const CosineTexel& box = row[0][own];
      for (std::size_t v = 0; v < 3; ++v) {
        CosineVertex& vertex = vertices[v];
        const CosineTexel& amplitude = row[columns[v]][own];
        const Draw draw = nextDraw(vertex.state);
        const float fx = box[0] + box[2] * draw.column, fy = box[1] + box[3] * draw.row;
        const float turns =
            fx * vertex.offset[0] + fy * vertex.offset[1] + draw.phase + amplitude[3];
        const float retained = retainedAt(ofWindow + footprint.squaredCycles(fx, fy));
        const float value = retained * cosineOfTurns(turns);
        constexpr float kRadians = 6.28318531f;
        const float sine = kRadians * vertex.weight * retained * cosineOfTurns(turns + 0.25f);
        for (std::size_t c = 0; c < 3; ++c) {
          sums[v][c] += value * amplitude[c];
          slopes.alongX[c] += fx * sine * amplitude[c];
          slopes.alongY[c] += fy * sine * amplitude[c];
        }
      }
      if (own + 1 == kRowCosines)
        row += kCosineColumns + variants;
    }
    const auto scale = float(std::ldexp(1.0, finerOctaves(int(octave), material)));
    const auto windows =
        windowSlopes(vertices, {scale * material.columnsPerTile, scale * material.rowsPerTile});
    for (std::size_t v = 0; v < 3; ++v)
      for (std::size_t c = 0; c < 3; ++c) {
        slopes.alongX[c] += windows[v][0] * sums[v][c];
        slopes.alongY[c] += windows[v][1] * sums[v][c];
      }
  }
  return slopes;
}

} // namespace lichen::local_random_phase
