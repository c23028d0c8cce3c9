#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Depth only. Fragments removed by an alpha mask cast no shadow, and neither do fragments of
// blended surfaces with alpha below 1/2, because depth cannot store partial coverage.
#include "surface.glsl"

layout(location = 0) in vec3 worldPosition;
layout(location = 1) in vec3 worldNormal;
layout(location = 2) in vec4 worldTangent;
layout(location = 3) in vec4 texCoords;
layout(location = 4) in vec4 vertexColor;
layout(location = 5) in float mixWeight;
layout(location = 6) in vec3 objectPosition;
layout(location = 7) in vec3 objectNormal;
layout(location = 8) in vec4 objectTangent;

const float kBlendedCutoff = 0.5;

void main() {
  Footprint footprint =
      Footprint(texCoords, dFdx(texCoords), dFdy(texCoords),
                Spot(worldPosition, dFdx(worldPosition), dFdy(worldPosition), worldNormal,
                     worldTangent),
                Spot(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec4(0.0)), vec3(0.0), mixWeight);
  if (kObjectSpaces)
    footprint.object = Spot(objectPosition, dFdx(objectPosition), dFdy(objectPosition),
                            objectNormal, objectTangent);
  LICHEN_SHADING_POINT shading;
  if (NOISE_HAS(LICHEN_OPACITY)) // only opacity needs it here
    shading = noisePoint(footprint);
  float cutoff = material.flags.y == ALPHA_BLEND ? kBlendedCutoff : material.emissive.w;
  if (material.baseColor.a * vertexColor.a * alphaAt(footprint, shading) < cutoff)
    discard;
}
