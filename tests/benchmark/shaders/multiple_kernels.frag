#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Multiple-kernels noise, as a material's base colour uses it.

// The usual material: an endless grid, fitted kernels, one table, known at compile time.
#include "interface/lichen_interface.h"
#define LICHEN_METHODS 8
#define LICHEN_MAPPINGS 1
#define LICHEN_FEATURES (8u | LICHEN_FEATURE_UV | LICHEN_FEATURE_TABLES)
#define LICHEN_SET 0
#define LICHEN_ROLES 1
#include "lichen.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 colour;

void main() {
  LichenShadingPoint shading = LICHEN_POINT(uv, dFdx(uv), dFdy(uv));
  colour = LICHEN_VALUE(LICHEN_BASE_COLOR, shading);
}
