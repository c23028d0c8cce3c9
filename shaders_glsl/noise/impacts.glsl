// SPDX-License-Identifier: MIT
// The impacts of a texton noise that reach a point: tile coordinate and footprint -> a walk over
// the offsets from the impacts to the point, and their signs.
// [GLM17] Galerne, Leclaire and Moisan 2017, section 3.2: points of a process of density lambda,
// signs +1 and -1. Here the points lie in the cells of a grid, one in each (stratified) or a
// Poisson number of mean 1; the covariance of the noise is the same, since the signs are
// independent. Specified bit for bit in docs/gltf_extension/README.md.

/// What all maps of a texton noise share at one point. Offsets from an impact or a
/// cell's corner to the point [texels] are in the frame of the impact's texton, from the middle of
/// its reach.
struct LichenImpacts {
  float footprintLevel; // of the mip that shows what the footprint does, at least 0
  float level;          // the same, as far as the textons have mips
  vec2 middle, radius; // [texels] of what a texton reaches, fetched at this level
  ivec2 firstCell;     // of those whose impacts may reach the point, in the period
  vec2 start, end;     // offsets to the point from corners of cells: first, beyond the last
  vec2 cellTexels;     // sides of a cell
  uint seedWord;       // of the hash
  float mixWeight;     // [0, 1] of a mix: from its first exemplar to its last
  vec2 mixGradient;    // [1 / tile] its derivative
#if LICHEN_HAS_SURFACES
  LichenSurfaceCubes cubes; // on a surface: what replaces the cells of a plane
#endif
};

/// A walk over the impacts of those cells. All of it but the last three members is about the next
/// one, which may turn out not to exist or not to reach the point.
struct LichenWalk {
  uvec3 cell;     // its cell and the seed, after the first step of the hash
  uint index;     // of it in its cell
  vec2 corner;    // offset from the cell's corner to the point
  bool isReached; // whether the last impact exists and reaches the point
  vec2 offset;    // from the last impact to the point
  float sign;     // of the last impact, +1 or -1
};

/// A whole float below 2^47 in magnitude, modulo 2^32.
uint lichenLowWord(float whole) {
  // Conversion of a float that no int holds is undefined: the two halves of the word by themselves.
  const float kHalfWord = 65536.0;
  float high = floor(whole / kHalfWord);
  return uint(int(high)) * 65536u + uint(int(whole - high * kHalfWord));
}

/// The number of a cell, a whole float below 2^47 in magnitude, or below 2^44 with a period of few
/// cells. Without a period: modulo 2^32. With one, of at most 2^29 cells: whole periods from the
/// cell, and fewer than 2^22 of them from [0, period).
uint lichenCellNumber(float cell, int period) {
  uint number = lichenLowWord(cell);
  // A quotient of floats is off by few periods, which lichenWrapped mends; their product would be
  // rounded, but modulo 2^32 it is exact, and so is what is left of the number.
  if (LICHEN_USES(LICHEN_FEATURE_PERIOD) && period != 0)
    number -= lichenLowWord(floor(cell / float(period))) * uint(period);
  return number;
}

/// The part of a frame outside of which bilinear fetches of a mip are 0: the coefficients, and half
/// a texel of the mip around them. [texels]
void lichenMipReach(float level, vec2 coefficients, LICHEN_OUT(vec2) low, LICHEN_OUT(vec2) high) {
  // Exact, as a device's exp2 need not be.
  float side = float(1 << int(ceil(level)));
  low = vec2(-0.5 * side);
  high = (ceil(coefficients / side) + 0.5) * side;
}

/// How far the footprint is from magnified, 0, to at least the first mip, 1.
float lichenMinified(LichenImpacts impacts) { return min(impacts.level, 1.0); }

/// The texels outside which a texton fetched with this footprint is 0.
void lichenReach(LichenImpacts impacts, LichenNoise noise, LICHEN_OUT(vec2) low,
                 LICHEN_OUT(vec2) high) {
  vec2 coefficients = lichenTextonCoefficients(noise);
  lichenMipReach(impacts.level, coefficients, low, high);
  float minified = lichenMinified(impacts);
  if (LICHEN_USES(LICHEN_FEATURE_CUBIC_TEXTONS) && lichenTextonNoise(noise).order == 3u &&
      minified < 1.0) {
    vec2 lowMip, highMip;
    lichenMipReach(minified, coefficients, lowMip, highMip);
    const float kReach = 1.5; // of a cubic B-spline beyond the border of its texel
    low = min(min(low, lowMip), vec2(-kReach));
    high = max(max(high, highMip), coefficients + kReach);
  }
}

/// Impacts around `position` [tiles, relative to the host's integer tile origin] whose textons
/// reach it.
void lichenSetPoint(LICHEN_OUT(LichenImpacts) impacts, vec2 position, vec2 gradientX,
                    vec2 gradientY, LichenMaterial material, LichenNoise noise) {
  vec2 texelsPerTile = vec2(noise.tileTexelsX, noise.tileTexelsY);
  vec2 cellsPerTile = vec2(material.columnsPerTile, material.rowsPerTile);
  vec2 coefficients = lichenTextonCoefficients(noise);
  impacts.footprintLevel = lichenSharpLevel(
      lichenFootprintLevel(gradientX * texelsPerTile, gradientY * texelsPerTile));
  impacts.level =
      min(impacts.footprintLevel, float(int(lichenTextonNoise(noise).mipCount) - 1));
  vec2 low, high;
  lichenReach(impacts, noise, low, high);
  impacts.middle = 0.5 * (low + high);
  impacts.radius = high - impacts.middle;
  // The centre of a texton's coefficients lies on its impact.
  vec2 grid = position * cellsPerTile;
  vec2 cell = floor(grid);
  vec2 inside = grid - cell;
  impacts.cellTexels = texelsPerTile / cellsPerTile;
  vec2 shift = 0.5 * coefficients - impacts.middle;
  vec2 first = floor(inside + (shift - impacts.radius) / impacts.cellTexels);
  vec2 last = floor(inside + (shift + impacts.radius) / impacts.cellTexels);
  impacts.start = shift + (inside - first) * impacts.cellTexels;
  // Half a cell further than the last: sums of sides are rounded.
  impacts.end = impacts.start - (last - first + 0.5) * impacts.cellTexels;
  impacts.firstCell =
      ivec2(uvec2(ivec2(first)) +
            uvec2(lichenCellNumber(cell.x, material.periodColumns) + uint(material.cellI),
                  lichenCellNumber(cell.y, material.periodRows) + uint(material.cellJ)));
  if (LICHEN_USES(LICHEN_FEATURE_PERIOD)) {
    impacts.firstCell.x = lichenWrapped(impacts.firstCell.x, material.periodColumns);
    impacts.firstCell.y = lichenWrapped(impacts.firstCell.y, material.periodRows);
  }
  impacts.seedWord = material.seedWord;
  impacts.mixWeight = 0.0;
  impacts.mixGradient = vec2(0.0);
}

#if LICHEN_HAS_SURFACES
/// How thick a layer of impacts a point sees. [texels]
float lichenSurfaceThickness(LichenNoise noise) {
  // [GLM17] section 6: r, the side of a square texton, or of the square with the same area.
  vec2 support = lichenTextonCoefficients(noise) + float(int(lichenTextonNoise(noise).order));
  return sqrt(support.x * support.y);
}

/// Sets the cubes around a point, whose footprint in the tangent plane is set. Offsets are in
/// texels, from the middle of the reach of an impact's texton.
void lichenSetSurfacePoint(LICHEN_INOUT(LichenImpacts) impacts, vec3 position, mat3 frame,
                           LichenMaterial material, LichenNoise noise) {
  LichenTextonMaterial own = lichenTextonMaterial(material);
  float side = own.surfaceCubeTexels;
  float greatestHeight = 0.5 * lichenSurfaceThickness(noise);
  mat3 axes = mat3(side * frame[0], side * frame[1], side / greatestHeight * frame[2]);
  vec3 grid = position * material.columnsPerTile;
  vec3 corner = floor(grid);
  // 2^28 tiles of 16384 texels have 2^46 cubes: cubes of 0.08 texels, for 1000 impacts of one
  // texel.
  uvec3 cell = uvec3(lichenLowWord(corner.x), lichenLowWord(corner.y), lichenLowWord(corner.z)) +
               uvec3(ivec3(material.cellI, material.cellJ, own.cellK));
  // The centre of a texton's coefficients lies on its impact.
  vec2 shift = 0.5 * lichenTextonCoefficients(noise) - impacts.middle;
  bool isPoisson = LICHEN_USES(LICHEN_FEATURE_POISSON_POINTS) &&
                   own.pointProcess == uint(LICHEN_POINTS_POISSON);
  impacts.cubes = lichenSurfaceCubesAt(grid - corner, cell, axes, vec3(shift, 0.0),
                               vec3(impacts.radius, 1.0), material.seedWord, isPoisson);
}
#endif

/// Where an impact lies in its cell, [0, 1).
vec2 lichenImpactInCell(uint word) {
  // 15 bits for each axis, below the sign's bit. They become the highest of the 23 mantissa bits of
  // a float in [1, 2), plus half a step: the middle of an interval. Exact.
  const uint kFractionBits = 0x7fff00u;
  const uint kOneAndHalfAStep = 0x3f800080u;
  return uintBitsToFloat((uvec2(word >> 8u, word << 7u) & kFractionBits) | kOneAndHalfAStep) - 1.0;
}

/// A walk before its first impact.
LichenWalk lichenFirstImpact(LichenImpacts impacts, LichenMaterial material) {
  LichenWalk walk;
  walk.cell =
      uvec3(uvec2(impacts.firstCell), impacts.seedWord) * kLichenPcg3dFactor + kLichenPcg3dTerm;
  walk.index = 0u;
  walk.corner = impacts.start;
  walk.isReached = false;
  walk.offset = vec2(0.0);
  walk.sign = 0.0;
  return walk;
}

/// The cell after one of these along an axis, both after the first step of the hash; the first one
/// after the last of the period.
uint lichenNextCell(uint cell, int period) {
  // A sum in place of a product: cell numbers wrap as the hash's words do.
  if (LICHEN_USES(LICHEN_FEATURE_PERIOD) &&
      cell == uint(period - 1) * kLichenPcg3dFactor + kLichenPcg3dTerm)
    return kLichenPcg3dTerm;
  return cell + kLichenPcg3dFactor;
}

/// To the next cell of the window, row by row.
void lichenNextCellOf(LICHEN_INOUT(LichenWalk) walk, LichenImpacts impacts,
                      LichenMaterial material) {
  walk.corner.x -= impacts.cellTexels.x;
  bool endsRow = walk.corner.x < impacts.end.x;
  uint first = uint(impacts.firstCell.x) * kLichenPcg3dFactor + kLichenPcg3dTerm;
  walk.cell.x = endsRow ? first : lichenNextCell(walk.cell.x, material.periodColumns);
  walk.cell.y = endsRow ? lichenNextCell(walk.cell.y, material.periodRows) : walk.cell.y;
  walk.corner = endsRow ? vec2(impacts.start.x, walk.corner.y - impacts.cellTexels.y) : walk.corner;
}

/// One step of a walk, to the next impact. Not to the next in reach: of pixels that are computed
/// together, all would wait for the one that finds its own last.
void lichenStep(LICHEN_INOUT(LichenWalk) walk, LichenImpacts impacts, LichenMaterial material,
                LichenNoise noise) {
  bool isPoisson = LICHEN_USES(LICHEN_FEATURE_POISSON_POINTS) &&
                   lichenTextonMaterial(material).pointProcess == uint(LICHEN_POINTS_POISSON);
  uvec3 hash = lichenPcg3dMix(walk.cell);
  uint word = isPoisson ? lichenPcg(hash.x + walk.index) : hash.x;
  uint count = isPoisson ? lichenPoissonCount(hash.y) : 1u;
  walk.offset = walk.corner - lichenImpactInCell(word) * impacts.cellTexels;
  walk.sign = uintBitsToFloat(floatBitsToUint(1.0) | (word & 0x80000000u));
  walk.isReached = walk.index < count && abs(walk.offset.x) < impacts.radius.x &&
                   abs(walk.offset.y) < impacts.radius.y;
  ++walk.index;
  if (!isPoisson || walk.index >= count) {
    walk.index = 0u;
    lichenNextCellOf(walk, impacts, material);
  }
}

/// Whether a walk has not come to the end of its cells.
bool lichenHasImpact(LichenWalk walk, LichenImpacts impacts) {
  return walk.corner.y > impacts.end.y;
}
