#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Evaluates one map of a quilting noise at a list of points:
// points[k] (uv, its gradients) -> values[k] (RGBA of the decoded quantity).
// For tests and for engines that fill a texture from a noise at run time.

#define LICHEN_METHODS 16
#define LICHEN_OMIT_TRIPLANAR
#define LICHEN_SET 0
#include "../lichen.glsl"
#include "one_role.glsl"

struct Point {
  vec4 uvAndGradientX;
  vec4 gradientY; // zw unused
};

layout(local_size_x = 64) in;
layout(std430, set = 1, binding = 0) readonly buffer Points { Point points[]; };
layout(std430, set = 1, binding = 1) writeonly buffer Values { vec4 values[]; };

vec4 evaluated(texture2D image, texture3D table, Point point) {
  return lichenValue(
      image, table,
      LICHEN_POINT(point.uvAndGradientX.xy, point.uvAndGradientX.zw, point.gradientY.xy),
      lichenMaps[kRole]);
}

void main() {
  uint index = gl_GlobalInvocationID.x;
  if (index >= uint(points.length()))
    return;
  vec4 value = vec4(0.0);
  LICHEN_EVALUATE(value, points[index]);
  values[index] = value;
}
