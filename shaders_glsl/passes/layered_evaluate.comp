#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Evaluates one map of a layered noise at a list of points of surfaces:
// points[k] (uv, position, their gradients, normal) -> values[k] (RGBA of the decoded
// quantity, or of slopes in space their gradient and variance).
// For tests and for engines that fill a texture from a noise at run time.

#ifndef LICHEN_LAYERS // the most that there are
#define LICHEN_LAYERS 4
#endif
#define LICHEN_ROLES 7
#define LICHEN_SET 0
#include "../lichen.glsl"

layout(constant_id = 1) const int kRole = LICHEN_BASE_COLOR;

struct Point {
  vec4 uvAndGradientX, uvGradientY; // zw of the latter unused
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
  LICHEN_SHADING_POINT shading = LICHEN_POINT_ANYWHERE(
      point.uvAndGradientX.xy, point.uvAndGradientX.zw, point.uvGradientY.xy, point.position.xyz,
      point.gradientX.xyz, point.gradientY.xyz, point.normal.xyz);
  if (kRole == LICHEN_BASE_COLOR)
    values[index] = LICHEN_VALUE(LICHEN_BASE_COLOR, shading);
  else if (kRole == LICHEN_NORMAL)
    values[index] = LICHEN_VALUE(LICHEN_NORMAL, shading);
  else
    values[index] = LICHEN_VALUE(LICHEN_OCCLUSION_ROUGHNESS_METALLIC, shading);
}
