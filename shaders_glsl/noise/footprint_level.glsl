// SPDX-License-Identifier: MIT
// At which mip a trilinear sampler fetches a pixel: its derivatives (two float2, texels) -> level.
// The CPU twin is analysis/sampling/footprint_level.
#ifndef LICHEN_FOOTPRINT_LEVEL_GLSL
#define LICHEN_FOOTPRINT_LEVEL_GLSL

/// The level at which a footprint of 2^lambda texels, lambda >= 0, is fetched.
float lichenSharpLevel(float lambda) {
  // A trilinear fetch averages more than its level says, by what it interpolates: half a level
  // lower it has the variance of a pixel's average (docs/decisions/018-texton-filtering.md).
  return max(0.5 * lambda, lambda - 0.5);
}

/// The level of the footprint with these derivatives [texels / pixel]: negative where it is
/// magnified, and not clamped to the last mip.
float lichenFootprintLevel(vec2 texelsX, vec2 texelsY) {
  const float kLeast = 1.0e-20; // texels^2; keeps log2 defined where nothing changes
  float squared = max(kLeast, max(dot(texelsX, texelsX), dot(texelsY, texelsY)));
  float longer = 0.5 * log2(squared);
  if (longer <= 0.0)
    return longer;
  // Of a slanted pixel a quarter of the way from the longer side to the shorter, which is at least
  // a texel: the least difference from its average (decision 018).
  const float kMostSlant = 16.0;
  float area = abs(texelsX.x * texelsY.y - texelsX.y * texelsY.x);
  float slant = min(squared / max(area, sqrt(squared)), kMostSlant);
  return lichenSharpLevel(longer - 0.25 * log2(slant));
}

#endif
