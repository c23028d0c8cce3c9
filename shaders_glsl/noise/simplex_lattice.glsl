// SPDX-License-Identifier: MIT
// The triangle of the simplex lattice that holds a point, and the barycentric weights in it.
// Tile coordinate (float2, tiles) -> three integer vertices, three weights that sum to 1.
// [HN18] Heitz and Neyret 2018, section 3; the lattice is specified bit for bit in
// docs/gltf_extension/README.md.
#ifndef LICHEN_SIMPLEX_LATTICE_GLSL
#define LICHEN_SIMPLEX_LATTICE_GLSL

#include "../interface/lichen_interface.h"

// 0 where no material has a periodic lattice. A literal, or the host's specialization constant.
#ifndef LICHEN_PERIODIC_LATTICE
#define LICHEN_PERIODIC_LATTICE 1
#endif

struct LichenTriangle {
  ivec3 i, j;   // the vertices (i[k], j[k]), not yet reduced to a period
  vec3 weights; // barycentric, [0, 1]
  ivec2 cell;   // that holds the point
  vec2 inside;  // where in it, [0, 1), skewed as the cells are
};

/// The triangle that holds `position` [tiles, relative to the host's integer tile origin].
LichenTriangle lichenTriangleAt(vec2 position, LichenNoise noise) {
  // [HN18] section 3: skewed coordinates, in which the triangles halve the unit squares.
  float row = position.y * noise.rowsPerTile;
  vec2 skewed = vec2(position.x * noise.columnsPerTile - 0.5 * row + noise.fractionI,
                     row + noise.fractionJ);
  vec2 cell = floor(skewed);
  vec2 inside = skewed - cell;
  // Float to int, never to uint: float to uint of a negative is undefined.
  ivec2 base = ivec2(cell) + ivec2(noise.cellI, noise.cellJ);
  float third = 1.0 - inside.x - inside.y;
  bool upper = third <= 0.0;
  LichenTriangle triangle;
  triangle.i = base.x + ivec3(upper ? 1 : 0, 1, 0);
  triangle.j = base.y + ivec3(upper ? 1 : 0, 0, 1);
  triangle.cell = base;
  triangle.inside = inside;
  triangle.weights = upper ? vec3(-third, 1.0 - inside.y, 1.0 - inside.x) : vec3(third, inside);
  return triangle;
}

/// The way to the point from each vertex, not yet reduced to a period: as exact far from the
/// origin as near it. [tiles]
void lichenWaysFromVertices(LichenTriangle triangle, LichenNoise noise, out vec3 wayX,
                            out vec3 wayY) {
  vec3 column = vec3(triangle.cell.x - triangle.i) + triangle.inside.x;
  vec3 row = vec3(triangle.cell.y - triangle.j) + triangle.inside.y;
  wayX = (column + 0.5 * row) / noise.columnsPerTile;
  wayY = row / noise.rowsPerTile;
}

/// floor(value / period) per component, for |value| < 2^22 and period > 0. Integer division is slow
/// on many devices. (value + 1/2) / period is at least 1 / (2 period) away from any integer, more
/// than the rounding of its product with the reciprocal.
ivec3 lichenFloorDivide(ivec3 value, int period) {
  return ivec3(floor((vec3(value) + 0.5) * (1.0 / float(period))));
}

/// Reduces the vertices to one period of a periodic lattice. `shiftX`, `shiftY`: the whole periods
/// taken away, in tiles. An infinite lattice is left alone. The cells of a periodic one are near
/// the origin, which the host reduces to one period: |i|, |j| < 2^22.
void lichenReduceToPeriod(inout LichenTriangle triangle, LichenNoise noise, out vec3 shiftX,
                          out vec3 shiftY) {
  shiftX = vec3(0.0);
  shiftY = vec3(0.0);
  if (bool(LICHEN_PERIODIC_LATTICE) && noise.periodRows > 0) {
    ivec3 rows = lichenFloorDivide(triangle.j, noise.periodRows);
    triangle.j -= rows * noise.periodRows;
    triangle.i += rows * (noise.periodRows / 2);
    ivec3 columns = lichenFloorDivide(triangle.i, noise.periodColumns);
    triangle.i -= columns * noise.periodColumns;
    shiftX = vec3(columns) * noise.periodTilesX;
    shiftY = vec3(rows) * noise.periodTilesY;
  }
}

#endif
