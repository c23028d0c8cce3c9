#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Evaluates one map of a tiling noise at a list of points:
// points[k] (uv and its gradients) -> values[k] (RGBA of the decoded quantity).
// For tests and for engines that fill a texture from a noise at run time.

#define LICHEN_METHODS 1
#define LICHEN_OMIT_TRIPLANAR
#define LICHEN_SET 0
#include "../lichen.glsl"
#include "one_role.glsl"

const int kValue = 0;
const int kGaussian = 1; // the blended Gaussian value, lost variance in alpha
layout(constant_id = 0) const int kQuantity = kValue;

struct Point {
  vec4 uvAndGradientX;
  vec4 gradientY; // zw unused
};

layout(local_size_x = 64) in;
layout(std430, set = 1, binding = 0) readonly buffer Points { Point points[]; };
layout(std430, set = 1, binding = 1) writeonly buffer Values { vec4 values[]; };

vec4 evaluated(texture2D image, texture3D table, Point point) {
  LichenMap map = lichenMaps[kRole];
  LichenShadingPoint shading =
      LICHEN_POINT(point.uvAndGradientX.xy, point.uvAndGradientX.zw, point.gradientY.xy);
  if (kQuantity == kGaussian) {
    vec3 lost;
    vec3 gaussian = lichenGaussianAt(image, table, shading.point.tiling, lichenMaterial,
                                     lichenNoise, map, lost);
    return vec4(gaussian, lost.x);
  }
  return lichenValue(image, table, shading, map);
}

void main() {
  uint index = gl_GlobalInvocationID.x;
  if (index >= uint(points.length()))
    return;
  vec4 value = vec4(0.0);
  LICHEN_EVALUATE(value, points[index]);
  values[index] = value;
}
