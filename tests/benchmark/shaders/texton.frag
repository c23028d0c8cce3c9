#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Texton noise of bilinear textons, as a material's base colour uses it.

// The usual material: an endless grid of stratified impacts, one exemplar, order 1, known at
// compile time.
#define LICHEN_METHODS 2
#define LICHEN_SURFACE 0
#define LICHEN_PERIODIC_LATTICE 0
#define LICHEN_POISSON_POINTS 0
#ifndef LICHEN_MIXED_TEXTONS // 1 in the variant of mixes
#define LICHEN_MIXED_TEXTONS 0
#endif
#define LICHEN_CUBIC_TEXTONS 0
#define LICHEN_NEAREST_TEXTONS 0
#define LICHEN_OMIT_TRIPLANAR
#define LICHEN_SET 0
#define LICHEN_ROLES 1
#include "lichen.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 colour;

void main() {
  LichenShadingPoint shading = LICHEN_POINT(uv, dFdx(uv), dFdy(uv));
  colour = LICHEN_VALUE(LICHEN_BASE_COLOR, shading);
}
