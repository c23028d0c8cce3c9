#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// A noise in a solid, on a plane in space, as local_random_phase.frag and multiple_kernels.frag have
// it on texture coordinates: the same pixels see the same texels. LICHEN_METHODS says which.

// The usual material, as there.
#include "interface/lichen_interface.h"
#define LICHEN_MAPPINGS 8
#define LICHEN_FEATURES                                                                            \
  (uint(LICHEN_METHODS) | LICHEN_FEATURE_SOLID | LICHEN_FEATURE_TABLES)
#define LICHEN_SET 0
#define LICHEN_ROLES 1
#include "lichen.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 colour;

void main() {
  const vec3 kRight = normalize(vec3(3.0, 0.0, -1.0)); // askew to the exemplar, as most surfaces
  const vec3 kDown = cross(normalize(vec3(1.0, 2.0, 3.0)), kRight);
  vec3 position = lichenNoise.tileSizeMetres * (uv.x * kRight + uv.y * kDown);
  LichenShadingPoint shading = LICHEN_POINT_SOLID(position, dFdx(position), dFdy(position));
  colour = LICHEN_VALUE(LICHEN_BASE_COLOR, shading);
}
