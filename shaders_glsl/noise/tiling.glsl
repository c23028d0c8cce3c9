// SPDX-License-Identifier: MIT
// Histogram-preserving tiling and blending: tile coordinate and footprint -> the material's value.
// Lattice, offsets and weights are computed once per fragment (lichenTilingTaps) and serve every
// map of the noise (lichenTiling). The CPU twin is analysis/tiling/evaluate.
// [HN18] Heitz and Neyret 2018. Deviations, with reasons: docs/decisions/.
#ifndef LICHEN_TILING_GLSL
#define LICHEN_TILING_GLSL

#include "../interface/lichen_interface.h"
#include "fewer_taps.glsl"
#include "footprint_level.glsl"
#include "hash.glsl"
#include "mip_variance.glsl"
#include "simplex_lattice.glsl"
#include "tile_rotation.glsl"
#include "tiling_decode.glsl"

// 1 when the images' sampler is anisotropic. Otherwise the level of detail is computed once per map
// instead of once per tap: cheaper, more exact where a driver approximates the level that it takes
// from gradients, and as sharp as a pixel's average.
#ifndef LICHEN_ANISOTROPIC
#define LICHEN_ANISOTROPIC 0
#endif

// 0 where every material's blendSharpness is 1. A literal, or the host's specialization constant.
#ifndef LICHEN_BLEND_SHARPNESS
#define LICHEN_BLEND_SHARPNESS 1
#endif

/// What all maps of a noise share at one point.
struct LichenTaps {
  vec2 position;         // [tiles] relative to the host's integer tile origin
  vec2 gradientX;        // [tiles / pixel] of the position along the screen's x
  vec2 gradientY;        // and y
  vec2 tap0, tap1, tap2; // [tiles] where each tile of the triangle is fetched
  vec3 weights;          // of the three tiles, sum 1; sorted where there are fewer taps
  float gain;            // contrast / sqrt(sum of squared weights)
  vec2 turn0, turn1, turn2; // (cosine, sine) of each tile's angle; (1, 0) where none is turned
  float tileAspect;         // width over height of a tile in space
  bool shareTexels;         // the taps share their place between texels
};

/// The offset of vertex (i, j)'s tile. [tiles]
vec2 lichenTileOffset(int i, int j, LichenNoise noise) {
  uvec2 index =
      lichenTileOffsetIndex(i, j, noise.seedWord, uvec2(noise.offsetCountX, noise.offsetCountY));
  // Through int, below 2^14: float of uint is slower on devices with only signed conversions.
  return vec2(ivec2(index)) * vec2(noise.offsetStepX, noise.offsetStepY);
}

/// Turns the tiles of a triangle that is reduced to a period. `wayX`, `wayY`: to the point from the
/// vertices as they were before [tiles].
void lichenTurnTaps(inout LichenTaps taps, LichenTriangle triangle, vec3 wayX, vec3 wayY,
                    LichenNoise noise) {
  taps.shareTexels = lichenTurnsKeepTexels(noise);
  taps.turn0 = lichenTileTurn(triangle.i.x, triangle.j.x, noise);
  taps.turn1 = lichenTileTurn(triangle.i.y, triangle.j.y, noise);
  vec2 way0 = taps.shareTexels ? taps.tap0 : vec2(wayX.x, wayY.x);
  vec2 way1 = taps.shareTexels ? taps.tap1 : vec2(wayX.y, wayY.y);
  taps.tap0 = lichenTurned(way0, taps.turn0, taps.tileAspect);
  taps.tap1 = lichenTurned(way1, taps.turn1, taps.tileAspect);
  if (LICHEN_TILING_TAPS > 2) {
    taps.turn2 = lichenTileTurn(triangle.i.z, triangle.j.z, noise);
    vec2 way2 = taps.shareTexels ? taps.tap2 : vec2(wayX.z, wayY.z);
    taps.tap2 = lichenTurned(way2, taps.turn2, taps.tileAspect);
  }
}

/// Lattice, weights and tap positions of a noise at one point. The gradients are those of
/// `position`, which is continuous; those of the taps are not.
LichenTaps lichenTilingTaps(vec2 position, vec2 gradientX, vec2 gradientY, LichenNoise noise) {
  // [HN18] Algorithm 1: the triangle and its three tiles.
  LichenTriangle triangle = lichenTriangleAt(position, noise);
  if (bool(LICHEN_BLEND_SHARPNESS) && noise.blendSharpness != 1.0) {
    triangle.weights = pow(triangle.weights, vec3(noise.blendSharpness));
    triangle.weights /= triangle.weights.x + triangle.weights.y + triangle.weights.z;
  }
  if (lichenHasFewerTaps())
    lichenTakeFewerTaps(triangle, gradientX, gradientY);
  vec3 wayX, wayY;
  lichenWaysFromVertices(triangle, noise, wayX, wayY);
  vec3 shiftX, shiftY;
  lichenReduceToPeriod(triangle, noise, shiftX, shiftY);
  vec2 offset0 = lichenTileOffset(triangle.i.x, triangle.j.x, noise);
  vec2 offset1 = lichenTileOffset(triangle.i.y, triangle.j.y, noise);
  vec2 offset2 = offset1; // of no weight with two taps
  if (LICHEN_TILING_TAPS > 2)
    offset2 = lichenTileOffset(triangle.i.z, triangle.j.z, noise);
  LichenTaps taps;
  taps.position = position;
  taps.gradientX = gradientX;
  taps.gradientY = gradientY;
  taps.tap0 = position - vec2(shiftX.x, shiftY.x);
  taps.tap1 = position - vec2(shiftX.y, shiftY.y);
  taps.tap2 = position - vec2(shiftX.z, shiftY.z);
  taps.turn0 = taps.turn1 = taps.turn2 = vec2(1.0, 0.0);
  taps.tileAspect = noise.tileAspect;
  taps.shareTexels = true;
  if (lichenTurnsTiles(noise))
    lichenTurnTaps(taps, triangle, wayX, wayY, noise);
  taps.tap0 += offset0;
  taps.tap1 += offset1;
  taps.tap2 += offset2;
  taps.weights = triangle.weights;
  taps.gain = noise.contrast * inversesqrt(dot(taps.weights, taps.weights));
  return taps;
}

/// The level of detail at which a map's image is fetched for the footprint, not clamped to its
/// mips; negative when magnified.
float lichenTilingLevel(LichenTaps taps, LichenNoise noise, LichenMap map) {
  vec2 size = vec2(map.widthTexels, map.heightTexels);
  vec2 texelsX = taps.gradientX * size;
  vec2 texelsY = taps.gradientY * size;
#if LICHEN_ANISOTROPIC
  // That of the sampler: log2 of the side of the square of texels that loses the same variance.
  vec2 squared = vec2(dot(texelsX, texelsX), dot(texelsY, texelsY));
  const float kLeast = 1.0e-20; // texels^2; keeps log2 and the ratio defined where nothing changes
  float major = max(max(squared.x, squared.y), kLeast);
  float minor = max(min(squared.x, squared.y), kLeast);
  float most = noise.maxAnisotropy * noise.maxAnisotropy;
  return 0.5 * log2(major) - 0.25 * log2(clamp(major / minor, 1.0, most));
#else
  return lichenFootprintLevel(texelsX, texelsY);
#endif
}

/// One tap of the Gaussian image, of a tile that is turned so.
vec3 lichenTilingFetch(sampler2D gaussian, vec2 tap, vec2 turn, LichenTaps taps, float level) {
#if LICHEN_ANISOTROPIC
  vec2 gradientX = taps.gradientX;
  vec2 gradientY = taps.gradientY;
  if (bool(LICHEN_TILE_ROTATION)) {
    gradientX = lichenTurned(gradientX, turn, taps.tileAspect);
    gradientY = lichenTurned(gradientY, turn, taps.tileAspect);
  }
  return textureGrad(gaussian, tap, gradientX, gradientY).rgb;
#else
  return textureLod(gaussian, tap, level).rgb;
#endif
}

/// Gaussian values of the tiles; the mean, 1/2, of one that is not taken.
struct LichenTiles {
  vec3 tile0, tile1, tile2;
};

LichenTiles lichenTilingTiles(sampler2D gaussian, LichenTaps taps, float level) {
  LichenTiles tiles;
  tiles.tile0 = lichenTilingFetch(gaussian, taps.tap0, taps.turn0, taps, level);
  tiles.tile1 = tiles.tile2 = vec3(0.5);
  if (lichenIsTaken(taps.weights.y))
    tiles.tile1 = lichenTilingFetch(gaussian, taps.tap1, taps.turn1, taps, level);
  if (LICHEN_TILING_TAPS > 2 && lichenIsTaken(taps.weights.z))
    tiles.tile2 = lichenTilingFetch(gaussian, taps.tap2, taps.turn2, taps, level);
  return tiles;
}

/// The tiles blended: mean 1/2, standard deviation 1/6 where nothing is minified.
vec3 lichenTilingBlend(LichenTiles tiles, LichenTaps taps) {
  // [HN18] eq. 8 on Gaussian values, about their mean 1/2.
  vec3 blend = taps.weights.x * tiles.tile0 + taps.weights.y * tiles.tile1;
  if (LICHEN_TILING_TAPS > 2)
    blend += taps.weights.z * tiles.tile2;
  return 0.5 + taps.gain * (blend - 0.5);
}

/// The blended Gaussian value of a map.
vec3 lichenTilingGaussian(sampler2D gaussian, LichenTaps taps, float level) {
  return lichenTilingBlend(lichenTilingTiles(gaussian, taps, level), taps);
}

/// The variance that a bilinear fetch of one mip keeps. `magnified` is 0 at one texel a pixel and
/// coarser, 1 from two pixels a texel on.
float lichenFetchKept(int mip, float magnified, LichenTaps taps, LichenMap map) {
  float kept = lichenMipKept(mip, map.mipKept0);
  // Midway between four texels the fetch is their average, a texel of the next mip.
  const float kLeast = 1.0e-3; // of the unorm bytes, below the smallest
  float loss = 4.0 - 4.0 * lichenMipKept(mip + 1, map.mipKept0) / max(kept, kLeast);
  // Where the taps do not share their place between texels, or pixels are smaller than texels and
  // would show the table's level as a mesh, the average over all places.
  const float kAverage = 1.0 / 6.0;
  vec2 size = vec2(map.widthTexels, map.heightTexels) * exp2(-float(mip));
  vec2 inside = fract(taps.position * size - 0.5);
  bool isShared = taps.shareTexels && mip < int(map.alignedMips);
  vec2 between = isShared ? inside * (1.0 - inside) : vec2(kAverage);
  vec2 share = 1.0 - loss * mix(between, vec2(kAverage), magnified);
  return kept * kept * share.x * share.y;
}

/// The variance of the Gaussian value that fetching loses, [0, 1] of its full variance.
float lichenTilingLostVariance(LichenTaps taps, float level, LichenMap map) {
  float clamped = clamp(level, 0.0, float(int(map.mipCount) - 1));
  int mip = int(clamped);
  float magnified = clamp(-level, 0.0, 1.0);
  float keptBelow = lichenFetchKept(mip, magnified, taps, map);
  float keptAbove = lichenFetchKept(mip + 1, magnified, taps, map);
  // A trilinear blend of a level and its own average.
  float rest = 1.0 - (clamped - float(mip));
  return 1.0 - (keptAbove + rest * rest * (keptBelow - keptAbove));
}

/// Of the lost variance, the share that the footprint takes, mips at the centres of their texels:
/// bilinear interpolation between texels reconstructs and hides no detail.
float lichenTilingFootprintShare(float level, float lostVariance, LichenMap map) {
  float lost = 1.0 - lichenLevelKept(clamp(level, 0.0, float(int(map.mipCount) - 1)), map);
  return lost < lostVariance ? lost / lostVariance : 1.0;
}

/// What the tiles stand for, of each of which `lost` of the variance is missing: of the slopes of
/// turned tiles what each does, turned back and blended about 0, where turning leaves their mean,
/// since a joint table knows slopes as they lie in the exemplar; otherwise what the `blend` does.
/// z of slopes is the variance of a slope over what is missing.
vec4 lichenTilingDecodeTiles(sampler3D table, LichenTiles tiles, vec3 blend, LichenTaps taps,
                             float lost, LichenNoise noise, LichenMap map) {
  bool isEach = map.encoding == uint(LICHEN_ENCODING_SLOPE) && lichenTurnsTiles(noise);
  vec3 shares = taps.weights * inversesqrt(dot(taps.weights, taps.weights));
  vec4 sum = vec4(0.0, 0.0, 0.0, 1.0);
  // One loop for both, tested at both ends: lichenTriplanarBlend says why.
  int count = 1;
  if (isEach && lichenIsTaken(taps.weights.y))
    count = 2;
  if (isEach && LICHEN_TILING_TAPS > 2 && lichenIsTaken(taps.weights.z))
    count = 3;
  int tile = 0;
  while (tile < count) {
    vec3 each = tile == 0 ? tiles.tile0 : (tile == 1 ? tiles.tile1 : tiles.tile2);
    vec3 gaussian = isEach ? 0.5 + noise.contrast * (each - 0.5) : blend;
    vec4 value = lichenTilingDecode(table, gaussian, lost, noise.contrast, map);
    if (isEach) {
      vec2 turn = tile == 0 ? taps.turn0 : (tile == 1 ? taps.turn1 : taps.turn2);
      float share = tile == 0 ? shares.x : (tile == 1 ? shares.y : shares.z);
      sum.xy += share * lichenSlopesTurnedBack(value.xy, turn);
      sum.z += share * share * value.z;
    } else {
      sum = value;
    }
    ++tile;
    if (tile >= count)
      break;
  }
  return sum;
}

/// The value of one map: light for colours, the decoded quantity for the others. Of slopes, z is
/// the variance of a slope that the footprint hides, for lichenRoughness.
vec4 lichenTiling(sampler2D gaussian, sampler3D table, LichenTaps taps, LichenNoise noise,
                  LichenMap map) {
  // [HN18] eq. 18.
  float level = lichenTilingLevel(taps, noise, map);
  float lost = lichenTilingLostVariance(taps, level, map);
  LichenTiles tiles = lichenTilingTiles(gaussian, taps, level);
  vec3 blend = lichenTilingBlend(tiles, taps);
  vec4 value = lichenTilingDecodeTiles(table, tiles, blend, taps, lost, noise, map);
  if (map.encoding == uint(LICHEN_ENCODING_SLOPE))
    value.z *= lichenTilingFootprintShare(level, lost, map);
  return value;
}

/// The three tiles decoded one by one and blended, `gain` times as far from the mean.
vec4 lichenTilingBlendDecoded(sampler2D gaussian, sampler3D table, LichenTaps taps, float gain,
                              LichenNoise noise, LichenMap map) {
  float level = lichenTilingLevel(taps, noise, map);
  float lost = lichenTilingLostVariance(taps, level, map);
  vec3 tile0 = lichenTilingFetch(gaussian, taps.tap0, taps.turn0, taps, level);
  vec3 tile1 = lichenTilingFetch(gaussian, taps.tap1, taps.turn1, taps, level);
  vec3 tile2 = lichenTilingFetch(gaussian, taps.tap2, taps.turn2, taps, level);
  vec4 value0 = lichenTilingDecode(table, tile0, lost, 1.0, map);
  vec4 value1 = lichenTilingDecode(table, tile1, lost, 1.0, map);
  vec4 value2 = lichenTilingDecode(table, tile2, lost, 1.0, map);
  vec4 middle = map.mean;
  if (map.encoding == uint(LICHEN_ENCODING_SLOPE) && lichenTurnsTiles(noise)) {
    value0.xy = lichenSlopesTurnedBack(value0.xy, taps.turn0);
    value1.xy = lichenSlopesTurnedBack(value1.xy, taps.turn1);
    value2.xy = lichenSlopesTurnedBack(value2.xy, taps.turn2);
    middle.xy = vec2(0.0);
  }
  vec4 blend = taps.weights.x * value0 + taps.weights.y * value1 + taps.weights.z * value2;
  return middle + gain * (blend - middle);
}

/// For comparison, [HN18] eq. 3, fig. 4: linear blending. Contrast is lost between vertices.
vec4 lichenTilingLinear(sampler2D gaussian, sampler3D table, LichenTaps taps, LichenNoise noise,
                        LichenMap map) {
  return lichenTilingBlendDecoded(gaussian, table, taps, noise.contrast, noise, map);
}

/// For comparison, [HN18] eq. 8, fig. 5: variance, but not the histogram, is kept. Values leave the
/// exemplar's range.
vec4 lichenTilingVariance(sampler2D gaussian, sampler3D table, LichenTaps taps, LichenNoise noise,
                          LichenMap map) {
  return lichenTilingBlendDecoded(gaussian, table, taps, taps.gain, noise, map);
}

#endif
