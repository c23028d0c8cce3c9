// SPDX-License-Identifier: MIT
// Random points in space that reach a point of a surface: the frame of its tangent plane -> a walk
// over the offsets from those points to the point, projected onto that plane, and their weights.
// Methods say how far an offset reaches, and what lies at a random point (an impact).
// [GLM17] Galerne, Leclaire and Moisan 2017, section 6. Impacts lie in cubes, one in each
// (stratified) or a Poisson number of mean 1. Specified bit for bit in
// docs/gltf_extension/README.md.

/// Cubes around a point. Offsets from an impact to the point have x and y along the tangent plane,
/// in the method's units, and the height over it, in units of that where the weight is 0. Cubes are
/// counted from the one that holds the point.
struct LichenSurfaceCubes {
  vec3 offset; // of the corner of the point's cube
  mat3 axes;   // the offset of an impact at `cube` [cubes] is `offset - cube * axes`
  vec3 radius; // impacts with smaller offsets reach the point
  uvec3 cell;  // the cube that holds the point, modulo 2^32
  uint seed;   // of the random numbers
  bool isPoisson;
  vec2 firstColumn, lastColumn; // columns of cubes along z whose impacts may reach the point
  // The part of a column, along z, in which each component of the offset is in reach: half its
  // length, its middle in the column (0, 0), and how the middle moves from column to column.
  vec3 columnReach, columnMiddle, columnStepX, columnStepY;
};

/// A walk over the cubes, column by column. All of it but the last five members is about the next
/// impact, which may turn out not to exist or not to reach the point. It is small: devices that
/// compute pixels together carry each member through their loops under a mask.
struct LichenSurfaceWalk {
  vec2 column; // from the point's
  uvec2 columnHash;
  float cube, lastCube; // from the point's, along z: the next, and the last of the column
  uint index;           // of the impact in its cube
  bool isReached;       // whether the last impact exists and reaches the point
  vec2 offset;          // from the last impact to the point
  float weight;         // of the last impact, with its sign
  uint word;            // its random numbers: place and sign take all bits but the lowest
  uvec3 cell;           // its cube, modulo 2^32
};

/// Cubes around a point at `inside` [cubes] of the cube `cell`. `axes` as in LichenSurfaceCubes,
/// with an inverse; `shift` is added to all offsets.
LichenSurfaceCubes lichenSurfaceCubesAt(vec3 inside, uvec3 cell, mat3 axes, vec3 shift, vec3 radius,
                                        uint seed, bool isPoisson) {
  LichenSurfaceCubes cubes;
  cubes.axes = axes;
  cubes.radius = radius;
  cubes.cell = cell;
  cubes.seed = seed;
  cubes.isPoisson = isPoisson;
  cubes.offset = inside * axes + shift;
  // The impacts in reach lie in a box that is askew among the cubes.
  mat3 toCubes = inverse(axes);
  vec3 middle = inside + shift * toCubes;
  vec3 reach = radius * mat3(abs(toCubes[0]), abs(toCubes[1]), abs(toCubes[2]));
  cubes.firstColumn = floor(middle.xy - reach.xy);
  cubes.lastColumn = floor(middle.xy + reach.xy);
  // Where a column leaves the box through each pair of faces. One that is parallel to a pair counts
  // as slightly slanted.
  const float kLeastSlope = 1.0 / 65536.0;
  vec3 alongX = vec3(axes[0].x, axes[1].x, axes[2].x);
  vec3 alongY = vec3(axes[0].y, axes[1].y, axes[2].y);
  vec3 alongZ = vec3(axes[0].z, axes[1].z, axes[2].z);
  vec3 least = kLeastSlope * (abs(alongX) + abs(alongY) + abs(alongZ));
  vec3 perOffset = 1.0 / mix(alongZ, least, lessThan(abs(alongZ), least));
  cubes.columnReach = (radius + 0.5 * (abs(alongX) + abs(alongY))) * abs(perOffset);
  cubes.columnStepX = -alongX * perOffset;
  cubes.columnStepY = -alongY * perOffset;
  cubes.columnMiddle = cubes.offset * perOffset + 0.5 * (cubes.columnStepX + cubes.columnStepY);
  return cubes;
}

/// Sets what a walk knows of its column.
void lichenEnterColumn(LICHEN_INOUT(LichenSurfaceWalk) walk, LichenSurfaceCubes cubes) {
  vec3 middle =
      cubes.columnMiddle + walk.column.x * cubes.columnStepX + walk.column.y * cubes.columnStepY;
  vec3 low = middle - cubes.columnReach;
  vec3 high = middle + cubes.columnReach;
  // A column out of reach still has one cube. Its impacts do not reach the point.
  walk.cube = floor(max(low.x, max(low.y, low.z)));
  walk.lastCube = floor(min(high.x, min(high.y, high.z)));
  uvec2 cell = cubes.cell.xy + uvec2(ivec2(walk.column));
  walk.columnHash = lichenPcg3d(uvec3(cell, cubes.seed)).xy;
}

/// A walk before its first impact.
LichenSurfaceWalk lichenFirstSurfaceImpact(LichenSurfaceCubes cubes) {
  LichenSurfaceWalk walk;
  walk.column = cubes.firstColumn;
  walk.index = 0u;
  walk.isReached = false;
  walk.offset = vec2(0.0);
  walk.weight = 0.0;
  walk.word = 0u;
  walk.cell = uvec3(0u);
  lichenEnterColumn(walk, cubes);
  return walk;
}

/// To the next column, row by row.
void lichenNextColumn(LICHEN_INOUT(LichenSurfaceWalk) walk, LichenSurfaceCubes cubes) {
  walk.column.x += 1.0;
  if (walk.column.x > cubes.lastColumn.x)
    walk.column = vec2(cubes.firstColumn.x, walk.column.y + 1.0);
  lichenEnterColumn(walk, cubes);
}

/// Where an impact lies in its cube, [0, 1).
vec3 lichenImpactInCube(uint word) {
  // As lichenImpactInCell, with 10 bits for each axis.
  const uint kFractionBits = 0x7fe000u;
  const uint kOneAndHalfAStep = 0x3f801000u;
  uvec3 bits = uvec3(word >> 8u, word << 2u, word << 12u) & kFractionBits;
  return uintBitsToFloat(bits | kOneAndHalfAStep) - 1.0;
}

/// One step of a walk, to the next impact; see lichenStep.
void lichenSurfaceStep(LICHEN_INOUT(LichenSurfaceWalk) walk, LichenSurfaceCubes cubes) {
  uint cell = cubes.cell.z + uint(int(walk.cube));
  walk.cell = uvec3(cubes.cell.xy + uvec2(ivec2(walk.column)), cell);
  uint word = lichenPcg(walk.columnHash.x + cell);
  uint count = 1u;
  if (cubes.isPoisson) {
    word = lichenPcg(word + walk.index);
    count = lichenPoissonCount(lichenPcg(walk.columnHash.y + cell));
  }
  vec3 impact = vec3(walk.column, walk.cube) + lichenImpactInCube(word);
  vec3 offset = cubes.offset - impact * cubes.axes;
  walk.offset = offset.xy;
  walk.word = word;
  // [GLM17] section 6: less and less of what is far from the tangent plane.
  float weight = 1.0 - abs(offset.z);
  walk.weight = (word & 0x80000000u) != 0u ? -weight : weight;
  walk.isReached = walk.index < count && all(lessThan(abs(offset), cubes.radius));
  ++walk.index;
  if (!cubes.isPoisson || walk.index >= count) {
    walk.index = 0u;
    walk.cube += 1.0;
    if (walk.cube > walk.lastCube)
      lichenNextColumn(walk, cubes);
  }
}

/// Whether a walk has not come to the end of its cubes.
bool lichenHasImpact(LichenSurfaceWalk walk, LichenSurfaceCubes cubes) {
  return walk.column.y <= cubes.lastColumn.y;
}
