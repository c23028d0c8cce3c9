// SPDX-License-Identifier: MIT
// The simplex lattice: a position in tiles -> the triangle around it. [HN18] section 3.
#ifndef LICHEN_SIMPLEX_LATTICE_GLSL
#define LICHEN_SIMPLEX_LATTICE_GLSL

#include "../interface/lichen_interface.h"

/// The triangle of the simplex lattice that holds a point.
struct LichenTriangle {
  uvec2 vertex0, vertex1, vertex2; // modulo 2^32
  vec3 weights;                    // barycentric, in [0, 1], sum 1
};

/// [tiles] -> [HN18] section 3's skewed coordinates, in which the triangles halve the unit squares.
vec2 lichenSkewed(vec2 position, LichenMaterial material) {
  float row = position.y * material.rowsPerTile;
  return vec2(position.x * material.columnsPerTile - 0.5 * row, row);
}

/// The triangle that holds a point given in skewed coordinates, relative to the noise's cell.
LichenTriangle lichenTriangle(vec2 skewed, LichenMaterial material) {
  vec2 cell = floor(skewed);
  vec2 inside = skewed - cell;
  float third = 1.0 - inside.x - inside.y;
  bool isUpper = third <= 0.0;
  // Through int: float to uint of a negative is undefined.
  uvec2 corner = uvec2(ivec2(cell)) + uvec2(ivec2(material.cellI, material.cellJ));
  LichenTriangle triangle;
  triangle.vertex0 = corner + uint(isUpper);
  triangle.vertex1 = corner + uvec2(1u, 0u);
  triangle.vertex2 = corner + uvec2(0u, 1u);
  triangle.weights = vec3(abs(third), mix(inside, 1.0 - inside.yx, bvec2(isUpper)));
  return triangle;
}

#endif
