// SPDX-License-Identifier: MIT
// A point -> its cell -> the four vertices around it in the lattice of an octave. Steps and names
// follow shaders_glsl/noise/solid_vertices.glsl.
#include "solid_vertices.h"

#include <lichen/lattice.h>

#include <algorithm>
#include <cmath>

namespace lichen::local_random_phase {
namespace {

using Vec3 = std::array<float, 3>;

/// The window at a squared distance [cubes^2], before the squares of all four sum to 1.
float solidWindowAt(float square) {
  constexpr float kPerSquaredRadius = 2.0f; // the height of a tetrahedron
  const float left = std::max(1.0f - kPerSquaredRadius * square, 0.0f);
  return left * left * left;
}

} // namespace

std::array<float, 3> cubesPerTile(const shader::LichenMaterial& material) {
  return {material.columnsPerTile, material.rowsPerTile, material.columnsPerTile};
}

SolidCell solidCellAt(const shader::LichenMaterial& material, const Vec3& position) {
  const Vec3 perTile = cubesPerTile(material);
  const Vec3 cubes{position[0] * perTile[0], position[1] * perTile[1], position[2] * perTile[2]};
  const float third = (cubes[0] + cubes[1] + cubes[2]) / 3.0f;
  const std::array<std::int32_t, 3> origin{material.cellI, material.cellJ,
                                           cosinesPart(material).cellK};
  SolidCell cell;
  for (std::size_t k = 0; k < 3; ++k) {
    const float skewed = cubes[k] + third, corner = std::floor(skewed);
    cell.cell[k] = std::uint32_t(std::int64_t(corner)) + std::uint32_t(origin[k]);
    cell.inside[k] = skewed - corner;
  }
  return cell;
}

std::array<SolidVertex, 4> solidVerticesAt(const SolidCell& cell, int octave,
                                           const shader::LichenMaterial& material) {
  const auto scale = float(std::ldexp(1.0, octave));
  Vec3 place{};
  std::array<std::uint32_t, 3> vertex{};
  for (std::size_t k = 0; k < 3; ++k) {
    const float at = cell.inside[k] * scale, corner = std::floor(at);
    place[k] = at - corner;
    vertex[k] = (cell.cell[k] << unsigned(octave)) + std::uint32_t(corner);
  }
  // From corner to corner of the cell, along the axes in the order of the place's coordinates.
  std::array<std::size_t, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return place[a] > place[b]; });
  const Vec3 perTile = cubesPerTile(material);
  const std::uint32_t seed = pcg(material.seedWord + std::uint32_t(octave));
  std::array<SolidVertex, 4> vertices;
  float squares = 0.0f;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const float sixth = (place[0] + place[1] + place[2]) / 6.0f;
    float square = 0.0f;
    for (std::size_t k = 0; k < 3; ++k) {
      const float offset = place[k] - sixth;
      square += offset * offset;
      vertices[v].offset[k] = offset / (scale * perTile[k]);
    }
    vertices[v].state = vertexHash(vertex[0], vertex[1], pcg(seed + vertex[2]));
    vertices[v].weight = solidWindowAt(square);
    squares += vertices[v].weight * vertices[v].weight;
    if (v + 1 == vertices.size())
      break;
    place[order[v]] -= 1.0f;
    vertex[order[v]] += 1;
  }
  for (SolidVertex& each : vertices)
    each.weight /= std::sqrt(squares);
  return vertices;
}

} // namespace lichen::local_random_phase
