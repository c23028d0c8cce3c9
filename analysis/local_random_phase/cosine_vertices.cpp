// SPDX-License-Identifier: MIT
// A point -> its cell -> the three vertices around it in the lattice of an octave. Steps and names
// follow shaders_glsl/noise/cosine_vertices.glsl.
#include "cosine_vertices.h"

#include "cosine.h"
#include "octave_lattice.h"

#include <lichen/lattice.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace lichen::local_random_phase {
namespace {

std::int32_t floorDivide(std::int32_t a, std::int32_t b) { return a / b - (a % b < 0 ? 1 : 0); }

/// Vertex (i, j) relative to the cell of the tile origin -> its representative in the period.
std::pair<std::int32_t, std::int32_t> periodicVertex(std::int32_t i, std::int32_t j,
                                                     std::int32_t columns, std::int32_t rows) {
  const std::int32_t rowPeriods = floorDivide(j, rows);
  j -= rowPeriods * rows;
  i += rowPeriods * (rows / 2);
  i -= floorDivide(i, columns) * columns;
  return {i, j};
}

} // namespace

int finerOctaves(int octave, const shader::LichenMaterial& material) {
  return std::max(octave - cosinesPart(material).firstOctave, 0);
}

CosineCell cosineCellAt(const shader::LichenMaterial& material,
                        const std::array<float, 2>& position) {
  const float row = position[1] * material.rowsPerTile;
  const float column = position[0] * material.columnsPerTile - 0.5f * row;
  const float left = std::floor(column), top = std::floor(row);
  std::int32_t i = std::int32_t(left), j = std::int32_t(top);
  if (material.periodRows > 0)
    std::tie(i, j) = periodicVertex(i, j, material.periodColumns, material.periodRows);
  return {i, j, column - left, row - top};
}

float squaredCyclesOfWindow(const WaveFootprint& footprint, int octave,
                            const shader::LichenMaterial& material) {
  const auto scale = float(std::ldexp(1.0, finerOctaves(octave, material)));
  const float columns = material.columnsPerTile * scale, rows = material.rowsPerTile * scale;
  // Rows are sqrt(3) / 2 edges apart.
  return kWindowSpread * (footprint.xx * columns * columns + 0.75f * footprint.yy * rows * rows);
}

std::array<CosineVertex, 3> verticesAt(const CosineCell& cell, int octave, std::uint32_t stream,
                                       const shader::LichenMaterial& material) {
  const int finer = finerOctaves(octave, material);
  const auto scale = float(std::ldexp(1.0, finer));
  const float column = cell.column * scale, row = cell.row * scale;
  const float left = std::floor(column), top = std::floor(row);
  const auto windows = windowsAt(column - left, row - top);
  const std::uint32_t seed = pcg(material.seedWord + stream);
  std::array<CosineVertex, 3> vertices;
  for (std::size_t k = 0; k < 3; ++k) {
    std::uint32_t i = (std::uint32_t(cell.i) << finer) + std::uint32_t(left) +
                      std::uint32_t(windows.corner[k][0]);
    std::uint32_t j =
        (std::uint32_t(cell.j) << finer) + std::uint32_t(top) + std::uint32_t(windows.corner[k][1]);
    if (material.periodRows > 0) {
      const auto reduced =
          periodicVertex(std::int32_t(i), std::int32_t(j), material.periodColumns << finer,
                         material.periodRows << finer);
      i = std::uint32_t(reduced.first);
      j = std::uint32_t(reduced.second);
    } else {
      i += std::uint32_t(material.cellI) << finer;
      j += std::uint32_t(material.cellJ) << finer;
    }
    const float a = windows.offset[k][0], b = windows.offset[k][1];
    vertices[k] = {
        vertexHash(i, j, seed),
        (i - j + 0x80000000u) % 3u, // far from the origin the difference wraps
        {(a + 0.5f * b) / (material.columnsPerTile * scale), b / (material.rowsPerTile * scale)},
        windows.weight[k]};
  }
  return vertices;
}

} // namespace lichen::local_random_phase
