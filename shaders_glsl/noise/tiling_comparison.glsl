// SPDX-License-Identifier: MIT
// For comparison: tiles decoded one by one and blended as values, without an inverse table after
// the blend. [HN18] figs. 4 and 5.
#ifndef LICHEN_TILING_COMPARISON_GLSL
#define LICHEN_TILING_COMPARISON_GLSL

#include "tiling_options.glsl"

vec4 lichenTilingBlendDecoded(LICHEN_IMAGE_2D gaussian, LICHEN_IMAGE_3D table,
                              LichenTilingTaps taps, float gain, LichenMap map) {
  LichenTiles tiles = lichenTilingTiles(gaussian, taps, map);
  const vec4 kShift = vec4(vec3(0.5 - 128.0 / 255.0), 0.0); // to the mean 1/2
  vec4 value0 = lichenTilingDecode(table, tiles.tile0 + kShift, tiles.lossShare, 1.0, map);
  vec4 value1 = lichenTilingDecode(table, tiles.tile1 + kShift, tiles.lossShare, 1.0, map);
  vec4 value2 = lichenTilingDecode(table, tiles.tile2 + kShift, tiles.lossShare, 1.0, map);
  vec4 middle = map.mean;
  if (map.encoding == uint(LICHEN_ENCODING_SLOPE) && taps.isRotated) {
    value0.xy = lichenSlopesRotatedBack(value0.xy, taps.rotation0);
    value1.xy = lichenSlopesRotatedBack(value1.xy, taps.rotation1);
    value2.xy = lichenSlopesRotatedBack(value2.xy, taps.rotation2);
    middle.xy = vec2(0.0);
  }
  vec3 weights = taps.point.weights;
  vec4 blend = weights.x * value0 + weights.y * value1 + weights.z * value2;
  return middle + gain * (blend - middle);
}

/// [HN18] eq. 3, fig. 4: linear blending. Contrast is lost between vertices.
vec4 lichenTilingLinear(LICHEN_IMAGE_2D gaussian, LICHEN_IMAGE_3D table, LichenTilingTaps taps,
                        LichenMap map) {
  return lichenTilingBlendDecoded(gaussian, table, taps, taps.point.contrast, map);
}

/// [HN18] eq. 8, fig. 5: variance, but not the histogram, is preserved. Values leave the exemplar's
/// range.
vec4 lichenTilingVariance(LICHEN_IMAGE_2D gaussian, LICHEN_IMAGE_3D table, LichenTilingTaps taps,
                          LichenMap map) {
  vec3 weights = taps.point.weights;
  float gain = taps.point.contrast * inversesqrt(dot(weights, weights));
  return lichenTilingBlendDecoded(gaussian, table, taps, gain, map);
}

#endif
