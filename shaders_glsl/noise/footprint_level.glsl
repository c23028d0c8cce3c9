// SPDX-License-Identifier: MIT
// At which mip level a trilinear sampler fetches a pixel, and what a bilinear fetch loses between
// texels: a position and its derivatives (float2, texels) -> level; share of the mean loss.
// Decision 3 has the measurements.

// 1 when tiling's sampler is anisotropic: fetches then pass gradients, not a level. A literal.
#ifndef LICHEN_ANISOTROPIC
#define LICHEN_ANISOTROPIC 0
#endif

/// log2 of the side [texels] of a pixel's footprint, at least 0: of a slanted one a quarter of the
/// way from the longer side to the shorter.
float lichenFootprintLevel(vec2 texelsX, vec2 texelsY) {
  // The shorter side counts as at least a texel, and as a sixteenth of the longer one.
  const float kMostSlant = 16.0;
  float squared = max(1.0, max(dot(texelsX, texelsX), dot(texelsY, texelsY)));
  float area = abs(texelsX.x * texelsY.y - texelsX.y * texelsY.x);
  return 0.25 * log2(squared * max(area, max(sqrt(squared), squared / kMostSlant)));
}

/// The mip level at which a footprint of 2^footprintLevel texels is fetched. A trilinear fetch
/// averages more than its level says, by what it interpolates: half a level lower it has the
/// variance of a pixel's average.
float lichenSharpLevel(float footprintLevel) {
  return max(0.5 * footprintLevel, footprintLevel - 0.5);
}

/// The mip level at which an anisotropic sampler loses what its footprint does: log2 of the side of
/// the square of texels that loses as much.
float lichenAnisotropicLevel(vec2 texelsX, vec2 texelsY, float maxAnisotropy) {
  vec2 squared = vec2(dot(texelsX, texelsX), dot(texelsY, texelsY));
  float major = max(max(squared.x, squared.y), 1.0);
  float minor = max(min(squared.x, squared.y), 1.0);
  return 0.5 * log2(major) - 0.25 * log2(min(major / minor, maxAnisotropy * maxAnisotropy));
}

/// What a bilinear fetch at `texel` loses, over the mean of all positions. All tiles lie alike
/// between texels. With one texel per pixel it is 0 at a texel's centre, where the view is exact.
/// In magnified views it is 1, because otherwise the texels would show as a mesh; in minified ones
/// too.
float lichenLossShare(vec2 texel, vec2 texelsX, vec2 texelsY, float footprintLevel) {
  // Between a texel and its neighbour with weights 1 - f and f the loss is in proportion to
  // f (1 - f), 1/6 on average on each axis.
  vec2 fromCentre = abs(fract(texel) - 0.5);
  float here = 3.0 * dot(fromCentre, 1.0 - fromCentre);
  float squared = min(1.0, max(dot(texelsX, texelsX), dot(texelsY, texelsY)));
  return mix(1.0, here, squared * squared * (1.0 - min(footprintLevel, 1.0)));
}

/// The share of the lost slope variance that counts as roughness. `loss` is the average over all
/// positions. Interpolation loses `interpolationLoss` of it even where the view is magnified.
/// Without that part, the variance that is drawn and the variance that is lost have a constant sum.
float lichenFootprintShare(float loss, float interpolationLoss) {
  const float kLeast = 1.0e-20;
  return max(loss - interpolationLoss, 0.0) / max(loss, kLeast);
}

/// The amplitude of a mip's texels, as a share of the Gaussian value's. `bytes` are the bytes of a
/// channel: LichenMap::mipRetained0, mipRetained1 or mipRetained2.
float lichenMipRetained(int mip, uvec4 bytes) {
  // Chosen, not indexed: a copied array that is indexed lives in memory on most devices.
  int byte = min(mip, LICHEN_MAX_MIPS - 1);
  uint word = byte < 8 ? (byte < 4 ? bytes.x : bytes.y) : (byte < 12 ? bytes.z : bytes.w);
  return float(int((word >> (8u * uint(byte & 3))) & 255u)) * (1.0 / 255.0);
}
