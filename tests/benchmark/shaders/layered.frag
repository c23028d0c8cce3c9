#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// A noise of two layers of tiling, as a material's base colour uses it.

// The usual material, as in tiling.frag; the index map has no table.
#include "interface/lichen_interface.h"
#define LICHEN_METHODS 1
#define LICHEN_MAPPINGS 1
#define LICHEN_FEATURES (1u | LICHEN_FEATURE_UV | LICHEN_FEATURE_TABLES)
#define LICHEN_LAYERS 2
#define LICHEN_SET 0
#define LICHEN_ROLES 1
#include "lichen.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 colour;

void main() {
  LICHEN_SHADING_POINT shading = LICHEN_POINT(uv, dFdx(uv), dFdy(uv));
  colour = LICHEN_VALUE(LICHEN_BASE_COLOR, shading);
}
