#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Textons on a surface, a plane in space, as texton.frag has them on texture coordinates: the same
// pixels see the same texels.

// The usual material, as there.
#include "interface/lichen_interface.h"
#define LICHEN_MAPPINGS 4
#define LICHEN_METHODS 2
#define LICHEN_FEATURES (2u | LICHEN_FEATURE_SURFACE | LICHEN_FEATURE_GAUSSIAN_ONLY)
#define LICHEN_SET 0
#define LICHEN_ROLES 1
#include "lichen.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 colour;

void main() {
  // A plane that is askew to the cubes, as most of a surface is.
  const vec3 kNormal = normalize(vec3(1.0, 2.0, 3.0));
  const vec3 kTangent = normalize(vec3(3.0, 0.0, -1.0));
  vec3 position =
      lichenNoise.tileSizeMetres * (uv.x * kTangent + uv.y * cross(kNormal, kTangent));
  LichenShadingPoint shading =
      LICHEN_POINT_SURFACE(position, dFdx(position), dFdy(position), kNormal, vec4(kTangent, -1.0));
  colour = LICHEN_VALUE(LICHEN_BASE_COLOR, shading);
}
