#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// The maps of all roles of a noise at a list of points: points[k] -> values[6 k ... 6 k + 5], -1
// where the noise lacks the map.
#define LICHEN_METHODS 3  // tiling, textons
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

#define WRITE_ROLE(role)                                                                           \
  values[6u * index + uint(role)] = LICHEN_HAS(role) ? LICHEN_VALUE(role, shading) : vec4(-1.0)

void main() {
  uint index = gl_GlobalInvocationID.x;
  if (index >= uint(points.length()))
    return;
  Point point = points[index];
  LichenShadingPoint shading =
      LICHEN_POINT(point.uvAndGradientX.xy, point.uvAndGradientX.zw, point.gradientY.xy);
  WRITE_ROLE(LICHEN_BASE_COLOR);
  WRITE_ROLE(LICHEN_NORMAL);
  WRITE_ROLE(LICHEN_OCCLUSION_ROUGHNESS_METALLIC);
  WRITE_ROLE(LICHEN_EMISSIVE);
  WRITE_ROLE(LICHEN_HEIGHT);
  WRITE_ROLE(LICHEN_OPACITY);
}
