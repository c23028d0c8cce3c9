#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Evaluates one map of a noise at a list of points of surfaces; see evaluate.glsl.
#define LICHEN_METHODS 10
#define LICHEN_MAPPINGS 4
#define LICHEN_SET 0
#include "../lichen.glsl"

// The tangent's w is glTF's, the others' the weight of a mix: of the gradients and the normal its
// weight and its derivatives per tile, of the position 0 where the material says them.
struct Point {
  vec4 position;
  vec4 gradientX, gradientY, normal;
  vec4 tangent;
};

LichenShadingPoint pointOf(Point point) {
  LichenShadingPoint shading =
      LICHEN_POINT_SURFACE(point.position.xyz, point.gradientX.xyz, point.gradientY.xyz,
                           point.normal.xyz, point.tangent);
  if (point.position.w != 0.0)
    lichenSetMix(shading.point, point.gradientX.w, vec2(point.gradientY.w, point.normal.w));
  return shading;
}

#include "evaluate.glsl"
