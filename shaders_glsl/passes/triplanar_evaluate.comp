#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Evaluates one map of a noise of any method in three planes at a list of points of surfaces; see
// evaluate.glsl.
#define LICHEN_MAPPINGS 2
#define LICHEN_SET 0
#include "../lichen.glsl"

struct Point {
  vec4 position;             // w: the weight of a mix, less than 0 where the material says it
  vec4 gradientX, gradientY; // w unused
  vec4 normal;               // w unused
};

LichenShadingPoint pointOf(Point point) {
  LichenShadingPoint shading = LICHEN_POINT_TRIPLANAR(
      point.position.xyz, point.gradientX.xyz, point.gradientY.xyz, point.normal.xyz);
  if (point.position.w >= 0.0)
    lichenSetMix(shading.point, point.position.w, vec2(0.0));
  return shading;
}

#include "evaluate.glsl"
