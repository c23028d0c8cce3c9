// SPDX-License-Identifier: MIT
// The lattices of local random-phase noise, one for each octave: a point on the plane of tiles ->
// the three vertices around it, with their windows and random numbers. [LRP14] section 3.1; the
// deviations are in docs/decisions/009-local-random-phase.md.

/// What all maps of a noise share at one point.
struct LichenCosinesPoint {
  ivec3 cell;    // of octave 0 that holds the point, from the cell of the tile origin on; of a
                 // plane z is 0, and the members below are set
  vec3 inside;   // the place in it, [0, 1)
  vec2 position; // [tiles] modulo whole tiles
  uvec2 origin;  // the cell of the tile origin, modulo 2^32
  uint seedWord; // of the plane, as is the origin
  vec2 gradientX, gradientY; // [tiles / pixel]
#if LICHEN_HAS_SOLIDS
  LichenSolidFootprint footprint; // of a solid
#endif
};

/// The number of cosines of an octave.
int lichenOctaveCosines(int octave, LichenCosinesNoise cosines) {
  uint word = octave < 4 ? cosines.octaves0 : (octave < 8 ? cosines.octaves1 : cosines.octaves2);
  return int((word >> (8u * uint(octave & 3))) & 255u);
}

/// The two numbers that a float's halves hold, with 8 significant bits each.
vec2 lichenBfloat16Pair(float pair) {
  uint bits = floatBitsToUint(pair);
  return vec2(uintBitsToFloat(bits & 0xFFFF0000u), uintBitsToFloat(bits << 16u));
}

/// The three vertices around a point in the lattice of one octave.
struct LichenCosinesVertices {
  uvec3 states;          // of their random numbers
  uvec3 colors;          // 0, 1 and 2 around each point, but for the ends of a period
  vec3 offsetX, offsetY; // [tiles] from each vertex to the point
  vec3 windows;          // the squares sum to 1
  vec2 spread;           // [cycles^2 / tile^2] mean square frequency of a window along x and y
};

/// The windows of three vertices, for the vectors from them in lattice coordinates. [LRP14] eq. 1
/// with a smaller window: it ends at the height of a triangle, within reach of no fourth vertex.
vec3 lichenCosineWindows(vec3 columns, vec3 rows) {
  const float kPerSquaredRadius = 4.0 / 3.0;
  vec3 squares = columns * columns + columns * rows + rows * rows; // of the distance, in edges
  vec3 left = max(1.0 - kPerSquaredRadius * squares, 0.0);
  vec3 windows = left * left * left;
  return windows * inversesqrt(dot(windows, windows));
}

/// A vertex (i, j) from the cell of the tile origin on -> modulo 2^32, or the vertex of the period
/// that stands for it.
uvec2 lichenCosineVertex(ivec2 vertex, int finer, uvec2 origin, LichenMaterial material) {
  if (!lichenIsPeriodic(material))
    return uvec2(vertex) + (origin << uint(finer));
  int columns = material.periodColumns << finer;
  int rows = material.periodRows << finer;
  // The cell lies in the first period.
  vertex += int(vertex.y >= rows) * ivec2(rows / 2, -rows);
  vertex.x %= columns;
  return uvec2(vertex);
}

/// `stream`: the number that their random numbers belong to.
LichenCosinesVertices lichenCosinesVertices(LichenCosinesPoint point, int octave, uint stream,
                                            LichenMaterial material) {
  // Octaves from the lattice of the material's first octave to this one's.
  int finer = max(octave - lichenCosinesMaterial(material).firstOctave, 0);
  float scale = float(1 << finer);
  vec2 place = point.inside.xy * scale;
  vec2 corner = floor(place);
  place -= corner;
  ivec2 cell = (point.cell.xy << finer) + ivec2(corner);
  int far = int(place.x + place.y >= 1.0);
  vec3 columns = place.x - vec3(float(far), 1.0, 0.0);
  vec3 rows = place.y - vec3(float(far), 0.0, 1.0);
  vec2 perCell = 1.0 / (scale * vec2(material.columnsPerTile, material.rowsPerTile)); // [tiles]
  uint seed = lichenPcg(point.seedWord + stream);
  uvec2 vertex0 = lichenCosineVertex(cell + far, finer, point.origin, material);
  uvec2 vertex1 = lichenCosineVertex(cell + ivec2(1, 0), finer, point.origin, material);
  uvec2 vertex2 = lichenCosineVertex(cell + ivec2(0, 1), finer, point.origin, material);
  LichenCosinesVertices vertices;
  vertices.states = uvec3(lichenVertexHash(vertex0.x, vertex0.y, seed),
                          lichenVertexHash(vertex1.x, vertex1.y, seed),
                          lichenVertexHash(vertex2.x, vertex2.y, seed));
  vertices.colors =
      uvec3(lichenVertexColor(vertex0), lichenVertexColor(vertex1), lichenVertexColor(vertex2));
  vertices.offsetX = (columns + 0.5 * rows) * perCell.x;
  vertices.offsetY = rows * perCell.y;
  vertices.windows = lichenCosineWindows(columns, rows);
  // In cycles^2 / edge^2; rows lie sqrt(3) / 2 edges apart.
  const float kSpread = 0.1733;
  vertices.spread = kSpread * vec2(1.0, 0.75) / (perCell * perCell);
  return vertices;
}
