// SPDX-License-Identifier: MIT
// Derivatives of a Gaussian value -> those of the decoded value, for bumps of a height.
#ifndef LICHEN_DECODED_GRADIENT_GLSL
#define LICHEN_DECODED_GRADIENT_GLSL

#include "../interface/fetch.glsl"
#include "../interface/lichen_interface.h"
#include "decode.glsl"

/// Derivatives of the Gaussian value along x and y [1 / tile], before the contrast.
struct LichenGaussianSlopes {
  vec3 alongX, alongY;
};

/// How much the first decoded channel changes along a direction of Gaussian values.
float lichenDecodedSlope(LICHEN_IMAGE_3D table, vec4 gaussian, vec3 slope, float contrast,
                         LichenMap map) {
  // A table has no derivative of its own: a difference over an eighth of the deviation.
  const float kStep = 1.0 / 96.0, kLeast = 1.0e-20;
  vec3 step = slope * (kStep / max(length(slope), kLeast));
  return contrast / (2.0 * kStep) * length(slope) *
         (lichenDecode(table, gaussian.rgb + step, gaussian.w, contrast, map).x -
          lichenDecode(table, gaussian.rgb - step, gaussian.w, contrast, map).x);
}

/// The first decoded channel and its derivatives. `gaussian`: the Gaussian value, in w the share of
/// its variance that filtering loses.
vec3 lichenDecodedGradient(LICHEN_IMAGE_3D table, vec4 gaussian, LichenGaussianSlopes slopes,
                           float contrast, LichenMap map) {
  return vec3(lichenDecode(table, gaussian.rgb, gaussian.w, contrast, map).x,
              lichenDecodedSlope(table, gaussian, slopes.alongX, contrast, map),
              lichenDecodedSlope(table, gaussian, slopes.alongY, contrast, map));
}

#endif
