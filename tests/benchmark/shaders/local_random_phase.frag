#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Local random-phase noise, as a material's base colour uses it.

// The usual material: an endless lattice, one table, known at compile time.
#include "interface/lichen_interface.h"
#define LICHEN_METHODS 4
#define LICHEN_MAPPINGS 1
#ifndef BENCH_FEATURES // of a variant
#define BENCH_FEATURES 0u
#endif
#define LICHEN_FEATURES (4u | LICHEN_FEATURE_UV | LICHEN_FEATURE_TABLES | BENCH_FEATURES)
#define LICHEN_SET 0
#define LICHEN_ROLES 1
#include "lichen.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 colour;

void main() {
  LichenShadingPoint shading = LICHEN_POINT(uv, dFdx(uv), dFdy(uv));
  colour = LICHEN_VALUE(LICHEN_BASE_COLOR, shading);
}
