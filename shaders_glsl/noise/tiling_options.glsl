// SPDX-License-Identifier: MIT
// Tiling with everything that a material or a host may ask of it, in place of tiling.glsl's point
// and value: blend sharpness, fewer taps, a periodic lattice, turned tiles, anisotropic samplers.
// Each costs nothing where its switch leaves it out. The CPU twin is analysis/tiling/evaluate.
#ifndef LICHEN_TILING_OPTIONS_GLSL
#define LICHEN_TILING_OPTIONS_GLSL

#include "decode.glsl"
#include "fewer_taps.glsl"
#include "periodic_lattice.glsl"
#include "tile_rotation.glsl"
#include "tiling.glsl"

// 0 where every material's blendSharpness is 1. A literal, or the host's specialization constant.
#ifndef LICHEN_BLEND_SHARPNESS
#define LICHEN_BLEND_SHARPNESS 1
#endif
// 1 when the images' sampler is anisotropic.
#ifndef LICHEN_ANISOTROPIC
#define LICHEN_ANISOTROPIC 0
#endif

/// What all maps of a noise share at one point.
struct LichenTilingTaps {
  LichenTilingPoint point;
  vec2 turn0, turn1, turn2;    // (cosine, sine) of each tile's angle; (1, 0) where none is turned
  vec2 gradientX, gradientY;   // [tiles / pixel] of the position; read with LICHEN_ANISOTROPIC 1
};

/// Where the tile of a vertex is fetched. `way`: from the vertex to the point. [tiles]
vec2 lichenTilingTap(ivec2 vertex, vec2 position, vec2 way, LichenNoise noise, out vec2 turn) {
  vec2 tap = position - lichenReduceToPeriod(vertex, noise);
  turn = vec2(1.0, 0.0);
  if (lichenTurnsTiles(noise)) {
    turn = lichenTileTurn(vertex, noise);
    tap = lichenTurned(lichenTurnsKeepTexels(noise) ? tap : way, turn, noise.tileAspect);
  }
  return tap + lichenTileOffset(vertex, noise);
}

/// The way to a point from a vertex that is not reduced to a period. [tiles]
vec2 lichenWayFromVertex(ivec2 vertex, vec2 skewed, LichenNoise noise) {
  // From the cell's corner to the point in cells, and from there to the vertex in whole ones: as
  // exact far from the origin as near it.
  vec2 cell = floor(skewed);
  vec2 cells = skewed - cell - vec2(vertex - ivec2(cell) - ivec2(noise.cellI, noise.cellJ));
  return vec2((cells.x + 0.5 * cells.y) / noise.columnsPerTile, cells.y / noise.rowsPerTile);
}

/// As lichenTilingPoint.
LichenTilingTaps lichenTilingTaps(vec2 position, vec2 gradientX, vec2 gradientY,
                                  LichenNoise noise) {
  vec2 skewed = lichenSkewedWithin(position, noise);
  LichenTriangle triangle = lichenTriangle(skewed, noise);
  if (bool(LICHEN_BLEND_SHARPNESS) && noise.blendSharpness != 1.0) {
    triangle.weights = pow(triangle.weights, vec3(noise.blendSharpness));
    triangle.weights /= triangle.weights.x + triangle.weights.y + triangle.weights.z;
  }
  if (lichenHasFewerTaps())
    lichenTakeFewerTaps(triangle, gradientX, gradientY);
  LichenTilingTaps taps;
  vec2 way0 = lichenWayFromVertex(triangle.vertex0, skewed, noise);
  vec2 way1 = lichenWayFromVertex(triangle.vertex1, skewed, noise);
  taps.point.uv0 = lichenTilingTap(triangle.vertex0, position, way0, noise, taps.turn0);
  taps.point.uv1 = lichenTilingTap(triangle.vertex1, position, way1, noise, taps.turn1);
  taps.point.uv2 = taps.point.uv1; // of no weight with two taps
  taps.turn2 = taps.turn1;
  if (LICHEN_TILING_TAPS > 2) {
    vec2 way2 = lichenWayFromVertex(triangle.vertex2, skewed, noise);
    taps.point.uv2 = lichenTilingTap(triangle.vertex2, position, way2, noise, taps.turn2);
  }
  taps.point.weights = triangle.weights;
  vec2 texels = vec2(noise.tileTexelsX, noise.tileTexelsY);
  vec2 texelsX = gradientX * texels;
  vec2 texelsY = gradientY * texels;
  taps.point.footprintLevel = lichenFootprintLevel(texelsX, texelsY);
  taps.point.lossShare =
      lichenLossShare(position * texels, texelsX, texelsY, taps.point.footprintLevel);
  if (lichenTurnsTiles(noise) && !lichenTurnsKeepTexels(noise))
    taps.point.lossShare = 1.0;
  taps.gradientX = gradientX;
  taps.gradientY = gradientY;
  return taps;
}

#if LICHEN_ANISOTROPIC
/// The mip level at which an anisotropic sampler loses what its footprint does: log2 of the side of
/// the square of texels that loses as much.
float lichenAnisotropicTilingLevel(LichenTilingTaps taps, LichenNoise noise, LichenMap map) {
  vec2 size = vec2(noise.tileTexelsX, noise.tileTexelsY) * exp2(map.levelOffset);
  vec2 texelsX = taps.gradientX * size;
  vec2 texelsY = taps.gradientY * size;
  vec2 squared = vec2(dot(texelsX, texelsX), dot(texelsY, texelsY));
  float major = max(max(squared.x, squared.y), 1.0);
  float minor = max(min(squared.x, squared.y), 1.0);
  float most = noise.maxAnisotropy * noise.maxAnisotropy;
  return 0.5 * log2(major) - 0.25 * log2(min(major / minor, most));
}
#endif

/// One tile; any value where it is not taken. An anisotropic sampler does not tell through
/// alpha what its probes lose together.
vec4 lichenTilingFetch(sampler2D gaussian, vec2 tap, vec2 turn, float weight,
                       LichenTilingTaps taps, float level, LichenNoise noise) {
  if (!lichenIsTaken(weight))
    return vec4(0.5);
#if LICHEN_ANISOTROPIC
  vec2 gradientX = taps.gradientX;
  vec2 gradientY = taps.gradientY;
  if (bool(LICHEN_TILE_ROTATION)) {
    gradientX = lichenTurned(gradientX, turn, noise.tileAspect);
    gradientY = lichenTurned(gradientY, turn, noise.tileAspect);
  }
  return textureGrad(gaussian, tap, gradientX, gradientY);
#else
  return textureLod(gaussian, tap, level);
#endif
}

/// The Gaussian values of the tiles.
struct LichenTiles {
  vec4 tile0, tile1, tile2;
};

LichenTiles lichenTilingTiles(sampler2D gaussian, LichenTilingTaps taps, LichenNoise noise,
                              LichenMap map) {
#if LICHEN_ANISOTROPIC
  float level = lichenAnisotropicTilingLevel(taps, noise, map);
#else
  float level = lichenTilingLevel(taps.point, map);
#endif
  vec3 weights = taps.point.weights;
  LichenTiles tiles;
  tiles.tile0 =
      lichenTilingFetch(gaussian, taps.point.uv0, taps.turn0, weights.x, taps, level, noise);
  tiles.tile1 =
      lichenTilingFetch(gaussian, taps.point.uv1, taps.turn1, weights.y, taps, level, noise);
  tiles.tile2 = vec4(0.5);
  if (LICHEN_TILING_TAPS > 2)
    tiles.tile2 =
        lichenTilingFetch(gaussian, taps.point.uv2, taps.turn2, weights.z, taps, level, noise);
#if LICHEN_ANISOTROPIC
  tiles.tile0.a = tiles.tile1.a = tiles.tile2.a =
      textureLod(gaussian, taps.point.uv0, level).a;
#else
  float lossShare = lichenTilingLossShare(taps.point, map);
  tiles.tile0.a *= lossShare;
  tiles.tile1.a *= lossShare;
  tiles.tile2.a *= lossShare;
#endif
  return tiles;
}

/// As lichenTilingGaussian.
vec4 lichenTilingGaussian(sampler2D gaussian, LichenTilingTaps taps, LichenNoise noise,
                          LichenMap map) {
  LichenTiles tiles = lichenTilingTiles(gaussian, taps, noise, map);
  return lichenTilingBlend(tiles.tile0, tiles.tile1, tiles.tile2, taps.point.weights, noise);
}

/// The value of one map.
vec4 lichenTiling(sampler2D gaussian, sampler3D table, LichenTilingTaps taps, LichenNoise noise,
                  LichenMap map) {
  LichenTiles tiles = lichenTilingTiles(gaussian, taps, noise, map);
  vec3 weights = taps.point.weights;
  vec4 blend = lichenTilingBlend(tiles.tile0, tiles.tile1, tiles.tile2, weights, noise);
  // The slopes of turned tiles are decoded one by one, turned back and blended about 0, where
  // turning leaves their mean: a joint table knows slopes as they lie in the exemplar. One loop for
  // both, tested at both ends, as lichenTriplanarBlend has it: devices that run both sides of a
  // branch leave a loop when no pixel has more.
  bool isEach = map.encoding == uint(LICHEN_ENCODING_SLOPE) && lichenTurnsTiles(noise);
  vec3 shares = weights * inversesqrt(dot(weights, weights));
  int count = isEach ? (LICHEN_TILING_TAPS > 2 ? 3 : 2) : 1;
  vec4 sum = vec4(0.0, 0.0, 0.0, 1.0);
  int tile = 0;
  while (tile < count) {
    vec4 each = tile == 0 ? tiles.tile0 : (tile == 1 ? tiles.tile1 : tiles.tile2);
    vec3 gaussianValue = isEach ? 0.5 + noise.contrast * (each.rgb - 128.0 / 255.0) : blend.rgb;
    vec4 value =
        lichenDecode(table, gaussianValue, isEach ? each.a : blend.a, noise.contrast, map);
    vec2 turn = tile == 0 ? taps.turn0 : (tile == 1 ? taps.turn1 : taps.turn2);
    float share = tile == 0 ? shares.x : (tile == 1 ? shares.y : shares.z);
    if (isEach)
      sum += vec4(share * lichenSlopesTurnedBack(value.xy, turn), share * share * value.z, 0.0);
    else
      sum = value;
    ++tile;
    if (tile >= count)
      break;
  }
  return sum;
}

#endif
