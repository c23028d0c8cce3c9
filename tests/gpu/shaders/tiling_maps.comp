#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Three maps of one noise at a list of points: points[k] -> values[3 k ... 3 k + 2].
#define LICHEN_METHODS 1  // tiling
#define LICHEN_MAPPINGS 1 // by texture coordinates
#define LICHEN_SET 0
#include "lichen.glsl"

struct Point {
  vec4 uvAndGradientX;
  vec4 gradientY; // zw unused
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
      LICHEN_POINT(point.uvAndGradientX.xy, point.uvAndGradientX.zw, point.gradientY.xy);
  values[3u * index] = LICHEN_VALUE(LICHEN_BASE_COLOR, shading);
  values[3u * index + 1u] = LICHEN_VALUE(LICHEN_NORMAL, shading);
  values[3u * index + 2u] = LICHEN_VALUE(LICHEN_OCCLUSION_ROUGHNESS_METALLIC, shading);
}
