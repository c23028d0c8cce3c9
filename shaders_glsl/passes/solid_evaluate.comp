#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Evaluates one map of a solid noise at a list of points in space:
// points[k] (position, its gradients) -> values[k] (RGBA of the decoded quantity, or of slopes
// their gradient in space and variance).
// For tests and for engines that bake a noise into the texture or the vertices of a mesh.

#define LICHEN_METHODS 12
#define LICHEN_OMIT_TRIPLANAR
#define LICHEN_SET 0
#include "../lichen.glsl"
#include "one_role.glsl"

const int kValue = 0;
const int kGaussian = 1; // the Gaussian value, and the share of its variance that filtering loses
layout(constant_id = 0) const int kQuantity = kValue;

struct Point {
  vec4 position, gradientX, gradientY; // w unused
};

layout(local_size_x = 64) in;
layout(std430, set = 1, binding = 0) readonly buffer Points { Point points[]; };
layout(std430, set = 1, binding = 1) writeonly buffer Values { vec4 values[]; };

vec4 evaluated(texture2D image, texture3D table, Point point) {
  LichenMap map = lichenMaps[kRole];
  LichenShadingPoint shading =
      LICHEN_POINT_SOLID(point.position.xyz, point.gradientX.xyz, point.gradientY.xyz);
  if (kQuantity == kValue)
    return lichenValue(image, table, shading, map);
  float depthSlope;
  return lichenSolidGaussian(image, shading.solid, lichenMaterial, lichenNoise, map, depthSlope);
}

void main() {
  uint index = gl_GlobalInvocationID.x;
  if (index >= uint(points.length()))
    return;
  vec4 value = vec4(0.0);
  LICHEN_EVALUATE(value, points[index]);
  values[index] = value;
}
