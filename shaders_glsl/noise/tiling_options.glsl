// SPDX-License-Identifier: MIT
// Tiling with everything that a material or a host may ask of it, in place of tiling.glsl's point
// and value: blend sharpness, lattices that are periodic or stretched along a grain, rotated tiles,
// anisotropic samplers.
// Each costs nothing where its switch leaves it out.
#ifndef LICHEN_TILING_OPTIONS_GLSL
#define LICHEN_TILING_OPTIONS_GLSL

#include "periodic_lattice.glsl"
#include "tile_rotation.glsl"
#include "tiling.glsl"
#include "tiling_decode.glsl"

// 0 where every material's blendSharpness is 1. A literal, or the host's specialization constant.
#ifndef LICHEN_BLEND_SHARPNESS
#define LICHEN_BLEND_SHARPNESS 1
#endif

// 0 where no noise of tiling has a grain. A literal, or the host's specialization constant.
#ifndef LICHEN_GRAIN
#define LICHEN_GRAIN 1
#endif

/// As lichenSkewed. Where no lattice is stretched or periodic, all have the same cells, which then
/// need not be read.
vec2 lichenSkewedFor(vec2 position, LichenMaterial material) {
  if (bool(LICHEN_GRAIN) || bool(LICHEN_PERIODIC_LATTICE))
    return lichenSkewed(position, material);
  return vec2(3.5 * position.x - 2.0 * position.y, 4.0 * position.y);
}

/// What all maps of a noise share at one point.
struct LichenTilingTaps {
  LichenTilingPoint point;
  vec2 rotation0, rotation1, rotation2; // (cosine, sine) of each tile's angle
  bool isRotated;                       // whether tiles are rotated
#if LICHEN_ANISOTROPIC
  vec2 gradientX, gradientY; // of the position [tiles / pixel]
  vec2 tileTexels;           // size of the widest map
  float maxAnisotropy;       // of the images' sampler
#endif
};

/// Where the tile of a vertex is fetched [tiles]; its rotation.
vec2 lichenTilingTap(uvec2 vertex, vec2 position, LichenMaterial material, LichenNoise noise,
                     LICHEN_OUT(vec2) rotation) {
  uint tileRotation = lichenTileRotation(material);
  vec2 tap = position - lichenReduceToPeriod(vertex, material);
  rotation = vec2(1.0, 0.0);
  if (tileRotation > 1u) {
    rotation = lichenTileRotationAt(vertex, tileRotation, material.seedWord);
    tap = lichenRotated(tap, rotation);
  }
  return tap + lichenTileOffset(vertex, material, noise);
}

/// As lichenTilingPoint.
void lichenSetPoint(LICHEN_OUT(LichenTilingTaps) taps, vec2 position, vec2 gradientX,
                    vec2 gradientY, LichenMaterial material, LichenNoise noise) {
  LichenTriangle triangle = lichenTriangle(lichenSkewedFor(position, material), material);
  float sharpness = lichenTilingMaterial(material).blendSharpness;
  if (bool(LICHEN_BLEND_SHARPNESS) && sharpness != 1.0) {
    triangle.weights = pow(triangle.weights, vec3(sharpness));
    triangle.weights /= triangle.weights.x + triangle.weights.y + triangle.weights.z;
  }
  taps.point.uv0 = lichenTilingTap(triangle.vertex0, position, material, noise, taps.rotation0);
  taps.point.uv1 = lichenTilingTap(triangle.vertex1, position, material, noise, taps.rotation1);
  taps.point.uv2 = lichenTilingTap(triangle.vertex2, position, material, noise, taps.rotation2);
  taps.point.weights = triangle.weights;
  taps.point.contrast = material.contrast;
  lichenSetTilingFootprint(taps.point, position, gradientX, gradientY, noise);
  taps.isRotated = lichenTileRotation(material) > 1u;
#if LICHEN_ANISOTROPIC
  taps.gradientX = gradientX;
  taps.gradientY = gradientY;
  taps.tileTexels = vec2(noise.tileTexelsX, noise.tileTexelsY);
  taps.maxAnisotropy = material.maxAnisotropy;
#endif
}

#if LICHEN_ANISOTROPIC
/// The mip level at which an anisotropic sampler loses what its footprint does: log2 of the side of
/// the square of texels that loses as much.
float lichenAnisotropicTilingLevel(LichenTilingTaps taps, LichenMap map) {
  vec2 size = taps.tileTexels * exp2(map.levelOffset);
  vec2 texelsX = taps.gradientX * size;
  vec2 texelsY = taps.gradientY * size;
  vec2 squared = vec2(dot(texelsX, texelsX), dot(texelsY, texelsY));
  float major = max(max(squared.x, squared.y), 1.0);
  float minor = max(min(squared.x, squared.y), 1.0);
  float most = taps.maxAnisotropy * taps.maxAnisotropy;
  return 0.5 * log2(major) - 0.25 * log2(min(major / minor, most));
}
#endif

vec4 lichenTilingFetch(LICHEN_IMAGE_2D gaussian, vec2 tap, vec2 rotation, LichenTilingTaps taps,
                       float level) {
#if LICHEN_ANISOTROPIC
  vec2 gradientX = taps.gradientX;
  vec2 gradientY = taps.gradientY;
  if (bool(LICHEN_TILE_ROTATION)) {
    gradientX = lichenRotated(gradientX, rotation);
    gradientY = lichenRotated(gradientY, rotation);
  }
  return LICHEN_SAMPLE_2D_GRAD(gaussian, tap, gradientX, gradientY);
#else
  return LICHEN_SAMPLE_2D(gaussian, tap, level);
#endif
}

/// The fetched tiles: rgb are Gaussian values, alpha is the share of the variance that fetches lose
/// on average over all positions.
struct LichenTiles {
  vec4 tile0, tile1, tile2;
  float lossShare; // the loss at this position, over that average
};

LichenTiles lichenTilingTiles(LICHEN_IMAGE_2D gaussian, LichenTilingTaps taps, LichenMap map) {
#if LICHEN_ANISOTROPIC
  float level = lichenAnisotropicTilingLevel(taps, map);
#else
  float level = lichenTilingLevel(taps.point, map);
#endif
  LichenTiles tiles;
  tiles.tile0 = lichenTilingFetch(gaussian, taps.point.uv0, taps.rotation0, taps, level);
  tiles.tile1 = lichenTilingFetch(gaussian, taps.point.uv1, taps.rotation1, taps, level);
  tiles.tile2 = lichenTilingFetch(gaussian, taps.point.uv2, taps.rotation2, taps, level);
#if LICHEN_ANISOTROPIC
  // Alpha does not tell what an anisotropic sampler's probes lose together.
  tiles.tile0.a = tiles.tile1.a = tiles.tile2.a =
      LICHEN_SAMPLE_2D(gaussian, taps.point.uv0, level).a;
#endif
  tiles.lossShare = lichenTilingLossShare(taps.point, map);
  return tiles;
}

/// The blend of the tiles, with the loss in alpha as they have it.
vec4 lichenTilesBlend(LichenTiles tiles, LichenTilingTaps taps) {
  return lichenTilingBlend(tiles.tile0, tiles.tile1, tiles.tile2, taps.point.weights,
                           taps.point.contrast);
}

/// As lichenTilingGaussian.
vec4 lichenTilingGaussian(LICHEN_IMAGE_2D gaussian, LichenTilingTaps taps, LichenMap map) {
  return lichenTilesBlend(lichenTilingTiles(gaussian, taps, map), taps);
}

/// The value of one map, of its tiles at these taps.
vec4 lichenTilesValue(LICHEN_IMAGE_3D table, LichenTiles tiles, LichenTilingTaps taps,
                      LichenMap map) {
  float contrast = taps.point.contrast;
  vec3 weights = taps.point.weights;
  vec4 blend = lichenTilesBlend(tiles, taps);
  // The slopes of rotated tiles are decoded one by one, rotated back and blended about 0, where
  // rotation leaves their mean: a joint table knows slopes as they lie in the exemplar. One loop
  // for both, tested at both ends, as lichenTriplanarGaussian has it: devices that run both sides
  // of a branch leave a loop when no pixel has more.
  bool isEach = map.encoding == uint(LICHEN_ENCODING_SLOPE) && taps.isRotated;
  vec3 shares = weights * inversesqrt(dot(weights, weights));
  int count = isEach ? 3 : 1;
  vec4 sum = vec4(0.0, 0.0, 0.0, 1.0);
  int tile = 0;
  while (tile < count) {
    vec4 each = tile == 0 ? tiles.tile0 : (tile == 1 ? tiles.tile1 : tiles.tile2);
    if (isEach)
      each = vec4(0.5 + contrast * (each.rgb - 128.0 / 255.0), each.a);
    else
      each = blend;
    vec4 value = lichenTilingDecode(table, each, tiles.lossShare, contrast, map);
    vec2 rotation = tile == 0 ? taps.rotation0 : (tile == 1 ? taps.rotation1 : taps.rotation2);
    float share = tile == 0 ? shares.x : (tile == 1 ? shares.y : shares.z);
    if (isEach)
      sum += vec4(share * lichenRotated(value.xy, rotation), share * share * value.z, 0.0);
    else
      sum = value;
    ++tile;
    if (tile >= count)
      break;
  }
  return sum;
}

// The seam's functions; see method.glsl.

vec3 lichenGaussianAt(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table, LichenTilingTaps taps,
                      LichenMaterial material, LichenNoise noise, LichenMap map,
                      LICHEN_OUT(vec3) lost) {
  vec4 gaussian = lichenTilingGaussian(image, taps, map);
  lost = vec3(gaussian.a * lichenTilingLossShare(taps.point, map));
  return gaussian.rgb;
}

vec4 lichenDecodedAt(LICHEN_IMAGE_3D table, vec3 gaussian, vec3 lost, LichenTilingTaps taps,
                     LichenMaterial material, LichenNoise noise, LichenMap map) {
  return lichenDecode(table, gaussian, lost.x, material.contrast, map);
}

vec4 lichenValueAt(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table, LichenTilingTaps taps,
                   LichenMaterial material, LichenNoise noise, LichenMap map) {
  return lichenTilesValue(table, lichenTilingTiles(image, taps, map), taps, map);
}

#endif
