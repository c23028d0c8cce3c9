#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// The base color of a tiling noise at a list of points, as passes/tiling_evaluate.comp, with the
// quality as a host's specialization constants.

layout(constant_id = 0) const int kTaps = 3;
layout(constant_id = 2) const float kOneTapTiles = 0.0;
#define LICHEN_TILING_TAPS kTaps
#define LICHEN_ONE_TAP_TILES kOneTapTiles
#define LICHEN_METHODS 1
#define LICHEN_OMIT_TRIPLANAR
#define LICHEN_SET 0
#define LICHEN_ROLES 1
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
  values[index] = LICHEN_VALUE(LICHEN_BASE_COLOR, shading);
}
