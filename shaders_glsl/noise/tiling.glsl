// SPDX-License-Identifier: MIT
// Histogram-preserving tiling and blending [HN18], from top to bottom: a point on the plane of
// tiles and its footprint -> three taps and their weights, once for all maps -> the Gaussian value
// of each map, with the share of its variance that fetches lose. tiling_decode.glsl makes the
// material's value of it.
// [HN18] Heitz and Neyret 2018, Algorithm 1. Deviations, with reasons: docs/decisions/.
#ifndef LICHEN_TILING_GLSL
#define LICHEN_TILING_GLSL

#include "../interface/fetch.glsl"
#include "../interface/lichen_interface.h"
#include "footprint_level.glsl"
#include "hash.glsl"
#include "simplex_lattice.glsl"

/// What all maps of a noise share at one point.
struct LichenTilingPoint {
  vec2 uv0, uv1, uv2; // [tiles] where the tile of each vertex is fetched
  vec3 weights;
  float footprintLevel; // [mip levels] of the widest map
  float lossShare;      // what a fetch loses at this position, over its mean; of the widest map
  float contrast;       // the material's
};

/// The random offset of a vertex's tile, a whole number of texels; images repeat. [tiles]
vec2 lichenTileOffset(uvec2 vertex, LichenMaterial material, LichenNoise noise) {
  uint hash = lichenVertexHash(vertex.x, vertex.y, material.seedWord);
  // Through int: float of uint is slower on devices with only signed conversions.
  ivec2 steps = ivec2(uvec2(hash & 0x7ffu, hash >> 21u));
  return vec2(steps) * vec2(noise.offsetStepX, noise.offsetStepY);
}

/// Sets what depends on the footprint, by the gradients [tiles / pixel] of `position` [tiles]:
/// those of the taps jump between triangles.
void lichenSetTilingFootprint(LICHEN_INOUT(LichenTilingPoint) point, vec2 position, vec2 gradientX,
                              vec2 gradientY, LichenNoise noise) {
  vec2 texels = vec2(noise.tileTexelsX, noise.tileTexelsY);
  point.footprintLevel = lichenFootprintLevel(gradientX * texels, gradientY * texels);
  point.lossShare = lichenLossShare(position * texels, gradientX * texels, gradientY * texels,
                                    point.footprintLevel);
}

/// Taps and weights at `position` [tiles, relative to the host's integer tile origin] of a pixel
/// with these gradients.
LichenTilingPoint lichenTilingPoint(vec2 position, vec2 gradientX, vec2 gradientY,
                                    LichenMaterial material, LichenNoise noise) {
  LichenTriangle triangle = lichenTriangle(lichenSkewed(position, material), material);
  LichenTilingPoint point;
  point.uv0 = position + lichenTileOffset(triangle.vertex0, material, noise);
  point.uv1 = position + lichenTileOffset(triangle.vertex1, material, noise);
  point.uv2 = position + lichenTileOffset(triangle.vertex2, material, noise);
  point.weights = triangle.weights;
  point.contrast = material.contrast;
  lichenSetTilingFootprint(point, position, gradientX, gradientY, noise);
  return point;
}

/// The mip level at which a map is fetched.
float lichenTilingLevel(LichenTilingPoint point, LichenMap map) {
  return lichenSharpLevel(point.footprintLevel + map.levelOffset);
}

/// The loss at this position, over the average. Smaller maps use the average: their tiles are not
/// offset by whole texels.
float lichenTilingLossShare(LichenTilingPoint point, LichenMap map) {
  return map.levelOffset == 0.0 ? point.lossShare : 1.0;
}

/// Three fetches blended: mean 1/2 and deviation 1/6 where nothing is minified. Alpha is the share
/// of the variance that fetches lose on average, which the image holds for each of its mip levels.
vec4 lichenTilingBlend(vec4 fetch0, vec4 fetch1, vec4 fetch2, vec3 weights, float contrast) {
  // [HN18] eq. 8 on Gaussian values, about their mean. The image holds it as a value of 8 bits.
  const float kStoredMean = 128.0 / 255.0;
  vec4 blend = weights.x * fetch0 + weights.y * fetch1 + weights.z * fetch2;
  float gain = contrast * inversesqrt(dot(weights, weights));
  return vec4(0.5 + gain * (blend.rgb - kStoredMean), blend.a);
}

/// The Gaussian value of a map, and in alpha that loss; tiling_decode.glsl has what it stands for.
vec4 lichenTilingGaussian(LICHEN_IMAGE_2D gaussian, LichenTilingPoint point, LichenMap map) {
  float level = lichenTilingLevel(point, map);
  return lichenTilingBlend(
      LICHEN_SAMPLE_2D(gaussian, point.uv0, level), LICHEN_SAMPLE_2D(gaussian, point.uv1, level),
      LICHEN_SAMPLE_2D(gaussian, point.uv2, level), point.weights, point.contrast);
}

#endif
