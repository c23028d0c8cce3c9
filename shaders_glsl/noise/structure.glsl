// SPDX-License-Identifier: MIT
// The structure of local random-phase noise: an image with the phases of the exemplar. A point and
// its footprint -> tiles of the image at the three vertices around it, magnified by cubic B-splines
// and blended so that the variance is the same everywhere. [LRP14] section 4.2;
// docs/decisions/028-structure.md. The CPU twin is analysis/local_random_phase/structure_tiles.
#ifndef LICHEN_STRUCTURE_GLSL
#define LICHEN_STRUCTURE_GLSL

#include "../interface/fetch.glsl"
#include "../interface/lichen_interface.h"
#include "cosine_vertices.glsl"
#include "footprint_level.glsl"
#include "method_parts.glsl"
#include "mip_variance.glsl"

/// Where an image of cosines has the structure; its sides are powers of two.
struct LichenStructureImage {
  ivec2 size;    // [texels of the structure] of level 0
  int levels;    // beyond them all is averaged out
  int offsets;   // of the list, 0: none
  int offsetRow; // of the list
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

/// The three integers of ten bits in a float.
vec3 lichenStructureTexel(uint bits) {
  return vec3(int(bits << 22u) >> 22, int(bits << 12u) >> 22,
              int((bits & 0x80000000u) | ((bits << 2u) & 0x7FC00000u)) >> 22);
}

/// The weights of a cubic B-spline for the four texels around a place, `t` beyond the second.
vec4 lichenSplineWeights(float t) {
  float left = 1.0 - t;
  vec4 weights;
  weights.x = left * left * left;
  weights.y = 4.0 + t * t * (3.0 * t - 6.0);
  weights.w = t * t * t;
  weights.z = 6.0 - weights.x - weights.y - weights.w;
  return weights / 6.0;
}

/// A level at `place` [texels]. Its texels begin at `corner` of the image, each texel of which
/// holds two columns of two rows.
vec3 lichenStructureAt(LICHEN_IMAGE_2D image, ivec2 corner, ivec2 size, vec2 place) {
  place -= 0.5;
  vec2 near = floor(place);
  vec4 x = lichenSplineWeights(place.x - near.x);
  vec4 y = lichenSplineWeights(place.y - near.y);
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
    // Chosen, not indexed: an indexed vector lives in memory on most devices.
    float even = row == 0 ? evenY.x : (row == 1 ? evenY.y : evenY.z);
    float odd = row == 0 ? oddY.x : (row == 1 ? oddY.y : oddY.z);
    for (int column = 0; column < 3; ++column) {
      ivec2 texel = corner + ((pair + ivec2(column, row)) & last);
      uvec4 bits = floatBitsToUint(LICHEN_FETCH_2D(image, texel));
      float left = column == 0 ? evenX.x : (column == 1 ? evenX.y : evenX.z);
      float right = column == 0 ? oddX.x : (column == 1 ? oddX.y : oddX.z);
      sum += even * (left * lichenStructureTexel(bits.x) + right * lichenStructureTexel(bits.y)) +
             odd * (left * lichenStructureTexel(bits.z) + right * lichenStructureTexel(bits.w));
    }
  }
  return sum;
}

/// The offset of a vertex's tile in the list, for 16 random bits: one of those of its color, so
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

/// Adds the structure: to the sum of Gaussian values, twice its variance to `squares`, and in w
/// twice what the footprint takes of it, as of cosines.
void lichenAddStructure(inout vec4 sum, inout float squares, LICHEN_IMAGE_2D image,
                        LichenCosinesPoint point, LichenMaterial material, LichenNoise noise,
                        LichenMap map) {
  const int kPlacementOctave = 2; // edges of a quarter of a tile
  LichenCosinesNoise shape = lichenCosinesNoise(noise);
  LichenStructureImage structure = lichenStructureImage(shape);
  vec2 size = vec2(structure.size);
  float level = min(lichenFootprintLevel(point.gradientX * size, point.gradientY * size),
                    float(structure.levels));
  int finer = int(level);
  float coarserShare = level - float(finer);
  bool isGuided = structure.offsets > 0 && lichenCosinesMaterial(material).guided != 0u;
  LichenCosinesVertices vertices = lichenCosinesVertices(
      point, kPlacementOctave, uint(LICHEN_MAX_OCTAVES), material);
  vec2 displacement = structure.turbulence * lichenTurbulence(vertices);
  // With a list, tiles are blended about their mean over it, which is the fourth.
  float meanWeight = 1.0 - vertices.windows.x - vertices.windows.y - vertices.windows.z;
  int tiles = shape.structure == 0u ? 0 : (isGuided ? 4 : 3);
  int end = min(coarserShare > 0.0 ? finer + 2 : finer + 1, structure.levels);
  vec3 integers = vec3(0.0);
  for (int tile = 0; tile < tiles; ++tile) {
    // Chosen, not indexed, as above.
    uint state = tile == 0 ? vertices.states.x
                           : (tile == 1 ? vertices.states.y : vertices.states.z);
    uint color = tile == 0 ? vertices.colors.x
                           : (tile == 1 ? vertices.colors.y : vertices.colors.z);
    vec2 fromVertex = tile == 0 ? vec2(vertices.offsetX.x, vertices.offsetY.x)
                                : (tile == 1 ? vec2(vertices.offsetX.y, vertices.offsetY.y)
                                             : vec2(vertices.offsetX.z, vertices.offsetY.z));
    vec2 place = displacement + (isGuided ? point.position : fromVertex);
    if (isGuided && tile < 3)
      place += lichenListedOffset(image, structure, state >> 16u, color);
    else if (tile < 3)
      place += vec2(ivec2(uvec2(state & 0xFFFFu, state >> 16u))) * (1.0 / 65536.0);
    int column = tile < 3 ? 0 : structure.size.x / 2;
    float weight = tile == 0 ? vertices.windows.x
                             : (tile == 1 ? vertices.windows.y
                                          : (tile == 2 ? vertices.windows.z : meanWeight));
    for (int k = finer; k < end; ++k) {
      int row = structure.offsetRow + (structure.offsets > 0 ? 1 : 0) + structure.size.y -
                (structure.size.y >> k);
      float share = k == finer ? 1.0 - coarserShare : coarserShare;
      ivec2 levelSize = structure.size >> k;
      integers += weight * share * lichenStructureAt(image, ivec2(column, row), levelSize,
                                                     place * vec2(levelSize));
    }
  }
  sum.rgb += map.sumFactor.rgb * integers;
  // Deviations of the structure over that of the noise, 1/6 in each channel.
  float whole = lichenMipRetained(0, map.mipRetained0);
  float left = mix(lichenMipRetained(finer, map.mipRetained0),
                   lichenMipRetained(finer + 1, map.mipRetained0), coarserShare);
  float perDeviation = float(map.dimensions) * (2.0 / 36.0);
  squares += perDeviation * whole * whole;
  sum.w += perDeviation * (whole * whole - left * left);
}

#endif
