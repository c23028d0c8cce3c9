// SPDX-License-Identifier: MIT
// The structure of local random-phase noise: an image with the phases of the exemplar. A point and
// its footprint -> tiles of the image at the three vertices around it, magnified by cubic B-splines
// and blended so that the variance is the same everywhere, with a list of offsets nearly so.
// [LRP14] section 5.1, eq. 4; docs/decisions/009-local-random-phase.md.

/// Where an image of cosines has the structure; its sides are powers of two.
struct LichenStructureImage {
  ivec2 size;       // [texels of the structure] of level 0
  int levels;       // beyond the last the mean alone is left
  int offsets;      // of the list, 0: none
  int offsetRow;    // of the list
  float turbulence; // [tiles]
};

LichenStructureImage lichenStructureImage(LichenCosinesNoise noise) {
  ivec2 log2Size = ivec2(noise.structure & 15u, (noise.structure >> 4u) & 15u);
  LichenStructureImage structure;
  structure.size = ivec2(1) << log2Size;
  structure.levels = min(log2Size.x, log2Size.y);
  structure.offsets = int((noise.structure >> 8u) & 255u);
  structure.offsetRow = int(noise.cosines) / 2;
  structure.turbulence = float(int(noise.structure >> 16u)) * (1.0 / 65535.0);
  return structure;
}

/// values[index]. An indexed vector would live in memory on most devices.
float lichenChosen(vec3 values, int index) {
  return index == 0 ? values.x : (index == 1 ? values.y : values.z);
}
uint lichenChosen(uvec3 values, int index) {
  return index == 0 ? values.x : (index == 1 ? values.y : values.z);
}

/// The three integers of ten bits in a float.
vec3 lichenStructureTexel(uint bits) {
  return vec3(int(bits << 22u) >> 22, int(bits << 12u) >> 22,
              int((bits & 0x80000000u) | ((bits << 2u) & 0x7FC00000u)) >> 22);
}

/// The weights of a cubic B-spline for the four texels around a position, `t` beyond the second.
vec4 lichenSplineWeights(float t) {
  float left = 1.0 - t;
  vec4 weights;
  weights.x = left * left * left;
  weights.y = 4.0 + t * t * (3.0 * t - 6.0);
  weights.w = t * t * t;
  weights.z = 6.0 - weights.x - weights.y - weights.w;
  return weights / 6.0;
}

/// A level at `texel` [texels]. Its texels begin at `corner` of the image, each texel of which
/// holds two columns of two rows.
vec3 lichenStructureAt(LICHEN_IMAGE_2D image, ivec2 corner, ivec2 size, vec2 texel) {
  texel -= 0.5;
  vec2 near = floor(texel);
  vec4 x = lichenSplineWeights(texel.x - near.x);
  vec4 y = lichenSplineWeights(texel.y - near.y);
  ivec2 first = ivec2(near) - 1;
  // Three pairs of columns and rows hold the four, from an even or an odd one on.
  bvec2 isOdd = equal(first & 1, ivec2(1));
  vec3 evenX = isOdd.x ? vec3(0.0, x.yw) : vec3(x.xz, 0.0);
  vec3 oddX = isOdd.x ? vec3(x.xz, 0.0) : vec3(x.yw, 0.0);
  vec3 evenY = isOdd.y ? vec3(0.0, y.yw) : vec3(y.xz, 0.0);
  vec3 oddY = isOdd.y ? vec3(y.xz, 0.0) : vec3(y.yw, 0.0);
  ivec2 pair = first >> 1;
  ivec2 last = size / 2 - 1;
  vec3 sum = vec3(0.0);
  for (int row = 0; row < 3; ++row) {
    float even = lichenChosen(evenY, row), odd = lichenChosen(oddY, row);
    for (int column = 0; column < 3; ++column) {
      uvec4 bits =
          floatBitsToUint(LICHEN_FETCH_2D(image, corner + ((pair + ivec2(column, row)) & last)));
      float left = lichenChosen(evenX, column), right = lichenChosen(oddX, column);
      sum += even * (left * lichenStructureTexel(bits.x) + right * lichenStructureTexel(bits.y)) +
             odd * (left * lichenStructureTexel(bits.z) + right * lichenStructureTexel(bits.w));
    }
  }
  return sum;
}

/// The offset of a vertex's tile in the list, for 16 random bits: one of its color's, so
/// that neighbours have others. [tiles]
vec2 lichenListedOffset(LICHEN_IMAGE_2D image, LichenStructureImage structure, uint random,
                        uint color) {
  uint count = (uint(structure.offsets) - color + 2u) / 3u;
  uint index = 3u * ((random * count) >> 16u) + color;
  vec4 pair = LICHEN_FETCH_2D(image, ivec2(index / 2u, structure.offsetRow));
  return (index & 1u) == 0u ? pair.xy : pair.zw;
}

/// A smooth random displacement of the deviation 1 along each axis: windows have squares of sum 1.
vec2 lichenTurbulence(LichenCosinesVertices vertices) {
  uvec3 states = vertices.states * 747796405u + 2891336453u;
  const float kPerBit = 3.4641016 / 4294967296.0; // of signed integers, which have 1 / sqrt(12)
  return kPerBit * vec2(dot(vertices.windows, vec3(ivec3(states << 11u))),
                        dot(vertices.windows, vec3(ivec3(states))));
}

/// Where a level begins in the image, from the first row of the levels on [texels of the image]:
/// level 1 is below level 0, and each of the others on the right of the one before.
ivec2 lichenLevelCorner(LichenStructureImage structure, int level) {
  if (level == 0)
    return ivec2(0);
  return ivec2(structure.size.x / 2 - (structure.size.x >> level), structure.size.y / 2);
}

/// Adds the structure to `sum.rgb`. Adds twice its variance to `squares`, and to `sum.w` twice the
/// variance that the footprint takes, like the squared amplitudes of cosines.
void lichenAddStructure(LICHEN_INOUT(vec4) sum, LICHEN_INOUT(float) squares, LICHEN_IMAGE_2D image,
                        LichenCosinesPoint point, LichenMaterial material, LichenNoise noise,
                        LichenMap map) {
  const int kPlacementOctave = 2; // edges of a quarter of a tile
  LichenCosinesNoise shape = lichenCosinesNoise(noise);
  bool hasStructures = LICHEN_USES(LICHEN_FEATURE_STRUCTURES);
  if (!hasStructures || shape.structure == 0u)
    return;
  LichenStructureImage structure = lichenStructureImage(shape);
  vec2 size = vec2(structure.size);
  float level = min(lichenFootprintLevel(point.gradientX * size, point.gradientY * size),
                    float(structure.levels));
  int finer = int(level);
  float coarserShare = level - float(finer);
  int end = min(coarserShare > 0.0 ? finer + 2 : finer + 1, structure.levels);
  LichenCosinesVertices vertices =
      lichenCosinesVertices(point, kPlacementOctave, uint(LICHEN_MAX_OCTAVES), material);
  vec2 displacement = structure.turbulence * lichenTurbulence(vertices);
  // With a list, tiles are blended about their mean over it, which is the fourth.
  bool isGuided = structure.offsets > 0 && lichenCosinesMaterial(material).guided != 0u;
  float meanWeight = 1.0 - vertices.windows.x - vertices.windows.y - vertices.windows.z;
  ivec2 firstRow = ivec2(0, structure.offsetRow + (structure.offsets > 0 ? 1 : 0));
  vec3 integers = vec3(0.0);
  for (int tile = 0; tile < (isGuided ? 4 : 3); ++tile) {
    vec2 position = displacement + point.position;
    uint state = lichenChosen(vertices.states, tile);
    if (tile < 3 && isGuided)
      position +=
          lichenListedOffset(image, structure, state >> 16u, lichenChosen(vertices.colors, tile));
    else if (tile < 3)
      position = displacement +
                 vec2(lichenChosen(vertices.offsetX, tile), lichenChosen(vertices.offsetY, tile)) +
                 vec2(ivec2(uvec2(state & 0xFFFFu, state >> 16u))) * (1.0 / 65536.0);
    float weight = tile < 3 ? lichenChosen(vertices.windows, tile) : meanWeight;
    ivec2 corner = firstRow + ivec2(tile < 3 ? 0 : structure.size.x / 2, 0);
    for (int k = finer; k < end; ++k) {
      float share = k == finer ? 1.0 - coarserShare : coarserShare;
      ivec2 levelSize = structure.size >> k;
      integers += weight * share *
                  lichenStructureAt(image, corner + lichenLevelCorner(structure, k), levelSize,
                                    position * vec2(levelSize));
    }
  }
  sum += vec4(map.sumFactor.rgb * integers, 0.0);
  // Deviations of the structure over the deviation of the noise, 1/6 in each channel.
  float whole = lichenMipRetained(0, map.mipRetained0);
  float retained = mix(lichenMipRetained(finer, map.mipRetained0),
                       lichenMipRetained(finer + 1, map.mipRetained0), coarserShare);
  float perDeviation = float(map.dimensions) * (2.0 / 36.0);
  squares += perDeviation * whole * whole;
  sum.w += perDeviation * (whole * whole - retained * retained);
}
