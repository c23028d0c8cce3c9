// SPDX-License-Identifier: MIT
// At which mip level a trilinear sampler fetches a pixel: its derivatives (two float2, texels) ->
// level. The CPU twin is analysis/sampling/footprint_level; decision 018 has the measurements.
#ifndef LICHEN_FOOTPRINT_LEVEL_GLSL
#define LICHEN_FOOTPRINT_LEVEL_GLSL

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

#endif
