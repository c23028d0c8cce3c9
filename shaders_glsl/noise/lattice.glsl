// SPDX-License-Identifier: MIT
// The simplex lattice: a position in tiles -> the triangle around it; vertices -> vertices of
// one period. [HN18] section 3.

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

/// In [0, 3): vertices side by side have different colors.
uint lichenVertexColor(uvec2 vertex) {
  // The difference wraps, and 2^32 is no multiple of 3: at half of it, far from the origin.
  return (vertex.x - vertex.y + 0x80000000u) % 3u;
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

/// `value` reduced to [0, period), for |value| < 2^22 periods; any value where the period is 0.
int lichenWrapped(int value, int period) {
  if (period == 0)
    return value;
  // Integer division is slow on many devices; the quotient of floats is off by 1 at most so far.
  int rest = value - int(floor(float(value) / float(period))) * period;
  return rest < 0 ? rest + period : (rest >= period ? rest - period : rest);
}

/// floor(value / period), for |value| < 2^20 and period > 0. Integer division is slow on many
/// devices. (value + 1/2) / period is at least 1 / (2 period) away from any integer, more than the
/// rounding of its product with the reciprocal.
int lichenFloorDivide(int value, int period) {
  return int(floor((float(value) + 0.5) * (1.0 / float(period))));
}

/// Reduces a vertex to one period and returns the whole periods taken away, in x and y [columns,
/// rows]. The cells of a periodic lattice are near the origin, which the host reduces to one period
/// of at most 65,536 tiles: |i|, |j| < 2^20.
ivec2 lichenWholePeriods(LICHEN_INOUT(ivec2) vertex, LichenMaterial material) {
  int rows = lichenFloorDivide(vertex.y, material.periodRows);
  vertex += rows * ivec2(material.periodRows / 2, -material.periodRows);
  int columns = lichenFloorDivide(vertex.x, material.periodColumns);
  vertex.x -= columns * material.periodColumns;
  return ivec2(columns, rows);
}

/// The same in tiles; an infinite lattice is left alone.
vec2 lichenReduceToPeriod(LICHEN_INOUT(uvec2) vertex, LichenMaterial material) {
  if (!lichenIsPeriodic(material))
    return vec2(0.0);
  ivec2 near = ivec2(vertex);
  ivec2 periods = lichenWholePeriods(near, material);
  vertex = uvec2(near);
  return vec2(periods) * vec2(material.periodTilesX, material.periodTilesY);
}
