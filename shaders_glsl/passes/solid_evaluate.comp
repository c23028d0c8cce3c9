#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Evaluates one map of a solid noise at a list of points in space; see evaluate.glsl.
#define LICHEN_METHODS 12
#define LICHEN_MAPPINGS 8
#define LICHEN_SET 0
#include "../lichen.glsl"

struct Point {
  vec4 position, gradientX, gradientY; // w unused
};

LichenShadingPoint pointOf(Point point) {
  return LICHEN_POINT_SOLID(point.position.xyz, point.gradientX.xyz, point.gradientY.xyz);
}

#include "evaluate.glsl"
