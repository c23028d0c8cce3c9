// SPDX-License-Identifier: MIT
// What a blend of tiles stands for: what tiling.glsl gives -> the material's value. For slopes, the
// variance that roughness shows is only that which the footprint hides.
#ifndef LICHEN_TILING_DECODE_GLSL
#define LICHEN_TILING_DECODE_GLSL

#include "decode.glsl"

/// Of the variance of slopes over what fetches lose on average, the share that the footprint hides,
/// and roughness shows: interpolation between texels hides nothing.
float lichenFootprintShare(float loss, LichenMap map) {
  float interpolation = map.interpolationLoss;
  return loss > interpolation ? (loss - interpolation) / (loss - loss * interpolation) : 0.0;
}

/// The value of what lichenTilingGaussian gives, at a point with this lossShare.
vec4 lichenTilingDecode(LICHEN_IMAGE_3D table, vec4 gaussian, float lossShare, float contrast,
                        LichenMap map) {
  vec4 value = lichenDecode(table, gaussian.rgb, lossShare * gaussian.a, contrast, map);
  if (map.encoding == uint(LICHEN_ENCODING_SLOPE))
    value.z *= lichenFootprintShare(gaussian.a, map);
  return value;
}

#endif
