// SPDX-License-Identifier: MIT
// The lattices of solid local random-phase noise, one for each octave: a point in the space of
// tiles -> the four vertices of the tetrahedron around it, with their windows and random numbers.
// They are body-centred cubic, each of half the edges of the octave before.
// docs/decisions/009-local-random-phase.md

#if LICHEN_HAS_SOLIDS
/// The four vertices around a point in the lattice of one octave.
struct LichenSolidVertices {
  uvec4 states;                   // of their random numbers
  vec4 offsetX, offsetY, offsetZ; // [tiles] from each vertex to the point
  vec4 windows;                   // the squares sum to 1
  vec3 spread; // [cycles^2 / tile^2] mean square frequency of a window along x, y and z
};

/// A point in the lattice's own coordinates [cubes]: vertices have integers.
vec3 lichenSkewed(vec3 cubes) { return cubes + (cubes.x + cubes.y + cubes.z) / 3.0; }
vec3 lichenUnskewed(vec3 place) { return place - (place.x + place.y + place.z) / 6.0; }

/// The square of the distance from a vertex [cubes^2] -> its window, before the squares of all four
/// sum to 1. It ends at the height of a tetrahedron, within reach of no fifth vertex.
vec4 lichenSolidWindows(vec4 squares) {
  const float kPerSquaredRadius = 2.0;
  vec4 left = max(1.0 - kPerSquaredRadius * squares, 0.0);
  return left * left * left;
}

uint lichenSolidHash(uvec3 vertex, uint seed) {
  return lichenVertexHash(vertex.x, vertex.y, lichenPcg(seed + vertex.z));
}

LichenSolidVertices lichenSolidVertices(LichenCosinesPoint point, int octave,
                                        LichenMaterial material) {
  float scale = float(1 << octave);
  vec3 place = point.inside * scale;
  vec3 corner = floor(place);
  place -= corner;
  uvec3 origin =
      uvec3(ivec3(material.cellI, material.cellJ, lichenCosinesMaterial(material).cellK));
  uvec3 first = uvec3((point.cell << octave) + ivec3(corner)) + (origin << uint(octave));
  // From corner to corner of the cell, along the axes in the order of the place's coordinates.
  bool xBeforeY = place.x >= place.y, xBeforeZ = place.x >= place.z, yBeforeZ = place.y >= place.z;
  vec3 step1 = vec3(xBeforeY && xBeforeZ, !xBeforeY && yBeforeZ, !xBeforeZ && !yBeforeZ);
  vec3 step2 = vec3(xBeforeY || xBeforeZ, !xBeforeY || yBeforeZ, !xBeforeZ || !yBeforeZ);
  uint seed = lichenPcg(material.seedWord + uint(octave));
  vec3 offset0 = lichenUnskewed(place);
  vec3 offset1 = lichenUnskewed(place - step1);
  vec3 offset2 = lichenUnskewed(place - step2);
  vec3 offset3 = lichenUnskewed(place - 1.0);
  LichenSolidVertices vertices;
  vertices.states =
      uvec4(lichenSolidHash(first, seed), lichenSolidHash(first + uvec3(step1), seed),
            lichenSolidHash(first + uvec3(step2), seed), lichenSolidHash(first + 1u, seed));
  vec4 windows = lichenSolidWindows(vec4(dot(offset0, offset0), dot(offset1, offset1),
                                         dot(offset2, offset2), dot(offset3, offset3)));
  vertices.windows = windows * inversesqrt(dot(windows, windows));
  vec3 cubesPerTile =
      scale * vec3(material.columnsPerTile, material.rowsPerTile, material.columnsPerTile);
  vertices.offsetX = vec4(offset0.x, offset1.x, offset2.x, offset3.x) / cubesPerTile.x;
  vertices.offsetY = vec4(offset0.y, offset1.y, offset2.y, offset3.y) / cubesPerTile.y;
  vertices.offsetZ = vec4(offset0.z, offset1.z, offset2.z, offset3.z) / cubesPerTile.z;
  const float kSpread = 0.3265; // cycles^2 / cube^2
  vertices.spread = kSpread * cubesPerTile * cubesPerTile;
  return vertices;
}
#endif
