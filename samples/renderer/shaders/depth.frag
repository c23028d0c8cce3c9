#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Depth alone; fragments that an alpha mask takes away cast no shadow, nor do those of blended
// surfaces that let through more than they cover: depth has no halves.
#include "surface.glsl"

layout(location = 0) in vec4 texCoords;
layout(location = 1) in float vertexAlpha;
layout(location = 2) in vec3 worldPosition;
layout(location = 3) in vec3 worldNormal;
layout(location = 4) in vec4 worldTangent;
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
  LichenPlace place;
  if (noiseHas(NOISE_OPACITY)) // of others the place is a cost without a use
    place = noisePlace(footprint);
  float cutoff = material.flags.y == ALPHA_BLEND ? kBlendedCutoff : material.emissive.w;
  if (material.baseColor.a * vertexAlpha * alphaAt(footprint, place) < cutoff)
    discard;
}
