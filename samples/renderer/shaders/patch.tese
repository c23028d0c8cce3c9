#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Displaces a vertex of the tessellator. `precise`: on an edge, where one weight is 0, the sums are
// the same from both sides.
#include "displacement.glsl"

layout(triangles, equal_spacing, ccw) in;
layout(location = 0) in SurfaceVertex corners[];

#define INTERPOLATE(member)                                                                        \
  v.member = gl_TessCoord.x * corners[0].member + gl_TessCoord.y * corners[1].member +             \
             gl_TessCoord.z * corners[2].member

void main() {
  precise SurfaceVertex v;
  INTERPOLATE(worldPosition);
  INTERPOLATE(worldNormal);
  INTERPOLATE(worldTangent);
  INTERPOLATE(texCoords);
  INTERPOLATE(vertexColor);
  INTERPOLATE(mixWeight);
  INTERPOLATE(objectPosition);
  INTERPOLATE(objectNormal);
  INTERPOLATE(objectTangent);
  INTERPOLATE(worldOutward);
  INTERPOLATE(direction);
  INTERPOLATE(relief);
  displace(v);
}
