// SPDX-License-Identifier: MIT
// Point in tile space -> three vertices. docs/gltf_extension/README.md specifies each step.
#include "lattice_vertices.h"

#include <cmath>

namespace lichen {
namespace {

std::int32_t wrappingSum(std::int32_t a, std::int32_t b) {
  return std::int32_t(std::uint32_t(a) + std::uint32_t(b));
}

std::int32_t floorDivide(std::int32_t a, std::int32_t b) { return a / b - (a % b < 0 ? 1 : 0); }

/// Sets the vertex (i, j), reduced to one period.
void setVertex(LatticeVertex& vertex, const shader::LichenMaterial& material, std::int32_t i,
               std::int32_t j) {
  if (material.periodRows > 0) {
    const std::int32_t rowPeriods = floorDivide(j, material.periodRows);
    j -= rowPeriods * material.periodRows;
    i += rowPeriods * (material.periodRows / 2);
    const std::int32_t columnPeriods = floorDivide(i, material.periodColumns);
    i -= columnPeriods * material.periodColumns;
    vertex.period = {float(columnPeriods) * material.periodTilesX,
                     float(rowPeriods) * material.periodTilesY};
  }
  vertex.i = std::uint32_t(i);
  vertex.j = std::uint32_t(j);
}

} // namespace

std::array<LatticeVertex, 3> latticeVertices(const shader::LichenMaterial& material,
                                             const std::array<float, 2>& position) {
  const float b = position[1] * material.rowsPerTile;
  const float a = position[0] * material.columnsPerTile - 0.5f * b;
  const float floorA = std::floor(a);
  const float floorB = std::floor(b);
  const std::int32_t i = wrappingSum(std::int32_t(floorA), material.cellI);
  const std::int32_t j = wrappingSum(std::int32_t(floorB), material.cellJ);
  const float f = a - floorA;
  const float g = b - floorB;

  std::array<LatticeVertex, 3> vertices;
  const bool lower = f + g < 1.0f;
  const std::int32_t corner = lower ? 0 : 1;
  const std::array<float, 3> weights = lower
                                           ? std::array<float, 3>{1.0f - f - g, f, g}
                                           : std::array<float, 3>{f + g - 1.0f, 1.0f - g, 1.0f - f};
  const std::array<std::array<std::int32_t, 2>, 3> corners{{{corner, corner}, {1, 0}, {0, 1}}};
  for (std::size_t k = 0; k < 3; ++k) {
    vertices[k].weight = weights[k];
    vertices[k].cells = {f - float(corners[k][0]), g - float(corners[k][1])};
    setVertex(vertices[k], material, wrappingSum(i, corners[k][0]), wrappingSum(j, corners[k][1]));
  }
  return vertices;
}

} // namespace lichen
