#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Tiling and blending, as a material's base colour uses it. The build says which kinds of table
// there are, and the quality.

// The usual material: an infinite lattice, plain weights and tiles that are not rotated, known at
// compile time.
#include "interface/lichen_interface.h"
#define LICHEN_METHODS 1
#define LICHEN_MAPPINGS 1
#define LICHEN_FEATURES (1u | LICHEN_FEATURE_UV | BENCH_FEATURES) // of the variant
#define LICHEN_SET 0
#ifdef BENCH_SLOPES // in place of colours
#define BENCH_ROLE LICHEN_NORMAL
#define LICHEN_ROLES 2
#else
#define BENCH_ROLE LICHEN_BASE_COLOR
#define LICHEN_ROLES 1
#endif
#include "lichen.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 colour;

void main() {
  LichenShadingPoint shading = LICHEN_POINT(uv, dFdx(uv), dFdy(uv));
  colour = LICHEN_VALUE(BENCH_ROLE, shading);
}
