#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Evaluates one map of a texton noise at a list of points:
// points[k] (uv, its gradients, weight of a mix) -> values[k] (RGBA of the decoded quantity).
// For tests and for engines that fill a texture from a noise at run time.

#define LICHEN_METHODS 2
#define LICHEN_OMIT_TRIPLANAR
#define LICHEN_SET 0
#include "../lichen.glsl"
#include "one_role.glsl"

const int kValue = 0;
const int kGaussian = 1; // the Gaussian value; 1
const int kGradient = 2; // stored value of the first channel, its derivatives per tile; 0
const int kImpacts = 3;  // how many reach the point, in all components
const int kLost = 4;     // the share of the variance that filtering loses of each channel; 0
layout(constant_id = 0) const int kQuantity = kValue;

struct Point {
  vec4 uvAndGradientX;
  vec4 gradientY; // zw unused
  vec4 mixWeight;  // weight, its derivatives per tile; w is 0 where the material says them
};

layout(local_size_x = 64) in;
layout(std430, set = 1, binding = 0) readonly buffer Points { Point points[]; };
layout(std430, set = 1, binding = 1) writeonly buffer Values { vec4 values[]; };

vec4 gradientAt(texture2D image, texture3D table, Point point) {
  vec2 uv = point.uvAndGradientX.xy;
  bool hasOwn = point.mixWeight.w != 0.0;
  return vec4(lichenGradientAt(
                  image, table,
                  vec2(lichenMaterial.offsetX, lichenMaterial.offsetY) +
                      lichenUvToTile(uv, lichenMaterial),
                  lichenUvToTile(point.uvAndGradientX.zw, lichenMaterial),
                  lichenUvToTile(point.gradientY.xy, lichenMaterial),
                  hasOwn ? point.mixWeight.x : lichenMixWeight(uv, lichenMaterial),
                  hasOwn ? point.mixWeight.yz : lichenMixGradient(lichenMaterial), lichenMaterial,
                  lichenNoise, lichenMaps[kRole]),
              0.0);
}

vec4 evaluated(texture2D image, texture3D table, Point point) {
  LichenMap map = lichenMaps[kRole];
  LichenShadingPoint shading =
      LICHEN_POINT(point.uvAndGradientX.xy, point.uvAndGradientX.zw, point.gradientY.xy);
  if (point.mixWeight.w != 0.0)
    lichenSetMix(shading.point.texton, point.mixWeight.x, point.mixWeight.yz);
  LichenImpacts impacts = shading.point.texton;
  if (kQuantity == kGradient)
    return gradientAt(image, table, point);
  if (kQuantity == kImpacts)
    return vec4(float(lichenImpactCount(impacts, lichenMaterial, lichenNoise)));
  if (kQuantity == kValue)
    return lichenValue(image, table, shading, map);
  vec3 lost;
  vec3 gaussian = lichenGaussianAt(image, table, impacts, lichenMaterial, lichenNoise, map, lost);
  return kQuantity == kGaussian ? vec4(gaussian, 1.0) : vec4(lost, 0.0);
}

void main() {
  uint index = gl_GlobalInvocationID.x;
  if (index >= uint(points.length()))
    return;
  vec4 value = vec4(0.0);
  LICHEN_EVALUATE(value, points[index]);
  values[index] = value;
}
