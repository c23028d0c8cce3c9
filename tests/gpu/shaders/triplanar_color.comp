#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// The base colour of a noise in three planes at a list of points of surfaces: points[k] ->
// values[k]. Without switches it has the code of all mappings and methods.
#define LICHEN_SET 0
#include "lichen.glsl"

struct Point {
  vec4 position, gradientX, gradientY, normal; // w unused
};

layout(local_size_x = 64) in;
layout(std430, set = 1, binding = 0) readonly buffer Points { Point points[]; };
layout(std430, set = 1, binding = 1) writeonly buffer Values { vec4 values[]; };

void main() {
  uint index = gl_GlobalInvocationID.x;
  if (index >= uint(points.length()))
    return;
  Point point = points[index];
  LichenShadingPoint shading =
      LICHEN_POINT_TRIPLANAR(point.position.xyz, point.gradientX.xyz, point.gradientY.xyz,
                             point.normal.xyz);
  values[index] = LICHEN_VALUE(LICHEN_BASE_COLOR, shading);
}
