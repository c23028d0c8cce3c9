// SPDX-License-Identifier: MIT
// The Gaussian value and the loss from tiling.glsl -> the material's value. Of the slope variance
// that fetches lose, only the part that the footprint hides makes the material rougher.
#ifndef LICHEN_TILING_DECODE_GLSL
#define LICHEN_TILING_DECODE_GLSL

#include "decode.glsl"

/// The share of the lost slope variance that counts as roughness. `loss` is what fetches lose on
/// average over all positions. Interpolation between texels is part of it, and of what a magnified
/// view lacks: without it, what is visible and what is hidden have the same sum at every distance.
float lichenFootprintShare(float loss, LichenMap map) {
  return loss > map.interpolationLoss ? 1.0 - map.interpolationLoss / loss : 0.0;
}

/// The value for `gaussian`, a result of lichenTilingGaussian, at a point with this lossShare.
vec4 lichenTilingDecode(LICHEN_IMAGE_3D table, vec4 gaussian, float lossShare, float contrast,
                        LichenMap map) {
  vec4 value = lichenDecode(table, gaussian.rgb, lossShare * gaussian.a, contrast, map);
  if (map.encoding == uint(LICHEN_ENCODING_SLOPE))
    value.z *= lichenFootprintShare(gaussian.a, map);
  return value;
}

#endif
