#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Depth alone; fragments that an alpha mask takes away cast no shadow.
#include "surface.glsl"

layout(location = 0) in vec4 texCoords;
layout(location = 1) in float vertexAlpha;

void main() {
  Footprint footprint = Footprint(texCoords, dFdx(texCoords), dFdy(texCoords));
  LichenTaps taps;
  if (kHasNoise)
    taps = noiseTaps(footprint);
  if (material.baseColor.a * vertexAlpha * alphaAt(footprint, taps) < material.emissive.w)
    discard;
}
