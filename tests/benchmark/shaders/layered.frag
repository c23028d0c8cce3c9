#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// A noise of two layers of tiling, as a material's base colour uses it.

// The usual material, as in tiling.frag and, of the index map, multiple_kernels.frag.
#define LICHEN_METHODS 9
#define LICHEN_LAYERS 2
#define LICHEN_LAYER_METHODS 1
#define LICHEN_LAYER_SLOTS 9
#define LICHEN_PERIODIC_LATTICE 0
#define LICHEN_GRAIN 0
#define LICHEN_BLEND_SHARPNESS 0
#define LICHEN_TILE_ROTATION 0
#define LICHEN_RING_KERNELS 0
#define LICHEN_SQUARE_KERNELS 0
#define LICHEN_KERNEL_PATTERN 0
#define LICHEN_OMIT_TRIPLANAR
#define LICHEN_OMIT_SOLID
#define LICHEN_SET 0
#define LICHEN_ROLES 1
#include "lichen.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 colour;

void main() {
  LICHEN_SHADING_POINT shading = LICHEN_POINT(uv, dFdx(uv), dFdy(uv));
  colour = LICHEN_VALUE(LICHEN_BASE_COLOR, shading);
}
