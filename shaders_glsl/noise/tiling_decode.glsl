// SPDX-License-Identifier: MIT
// The Gaussian value and the loss from tiling.glsl -> the material's value. Of the slope variance
// lost to filtering, only what interpolation does not explain makes the material rougher.
#ifndef LICHEN_TILING_DECODE_GLSL
#define LICHEN_TILING_DECODE_GLSL

#include "decode.glsl"

/// The share of the lost slope variance that counts as roughness. `loss` is the average over all
/// positions. Interpolation loses interpolationLoss of it even where the view is magnified. Without
/// that part, the variance that is drawn and the variance that is lost have a constant sum.
float lichenFootprintShare(float loss, LichenMap map) {
  const float kLeast = 1.0e-20;
  return max(loss - map.interpolationLoss, 0.0) / max(loss, kLeast);
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
