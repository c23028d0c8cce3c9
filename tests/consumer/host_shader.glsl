#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// A host's shader for any stage, with its own short names before and after the include. OWN_ARRAYS:
// it keeps its images in arrays and gives the functions an index. OWN_CELLS: it also defines how
// the cells of quilting are fetched.
#define SCALE 2.0
struct Taps { float weight; };
struct Noise { vec4 mean; };
float hash(vec2 p) { return fract(p.x + p.y); }
vec2 uvToTile(vec2 uv) { return SCALE * uv; }
const float gaussian = 0.5;

#ifdef OWN_ARRAYS
layout(set = 0, binding = 0) uniform sampler2D images[8];
layout(set = 0, binding = 1) uniform sampler3D tables[8];
#define LICHEN_IMAGE_2D int
#define LICHEN_IMAGE_3D int
#define LICHEN_SAMPLE_2D(image, uv, level) textureLod(images[image], uv, level)
#define LICHEN_SAMPLE_2D_GRAD(image, uv, uvX, uvY) textureGrad(images[image], uv, uvX, uvY)
#define LICHEN_SAMPLE_3D(image, uvw, level) textureLod(tables[image], uvw, level)
#define LICHEN_FETCH_2D(image, texel) texelFetch(images[image], texel, 0)
#include "interface/lichen_interface.h"
layout(std430, set = 0, binding = 2) readonly buffer Noises { LichenNoiseConstants noises[]; };
#ifdef OWN_CELLS
int cellsIndex = 7, noiseIndex = 0;
#define LICHEN_SAMPLE_CELLS(uv, level) textureLod(images[cellsIndex], uv, level)
#define LICHEN_TILE_OFFSET(index) noises[noiseIndex].offsets[(index) >> 2u][(index) & 3u]
#endif
#endif
#include "lichen.glsl"

#ifdef OWN_ARRAYS
layout(std430, set = 0, binding = 3) readonly buffer Materials { LichenMaterial materials[]; };
#endif

float tiling(vec3 weights, Taps taps) { return dot(weights, vec3(taps.weight)); }
vec4 decode(Noise noise, float level) { return noise.mean * level; }

void main() {
  vec2 uv = uvToTile(vec2(hash(vec2(gaussian))));
#ifdef OWN_ARRAYS
  LichenMaterial material = materials[1];
  LichenShadingPoint shading = lichenPointUvGrad(uv, vec2(0.01, 0.0), vec2(0.0, 0.01), material,
                                        noises[material.noise].noise);
  vec4 sum = lichenValue(0, 1, shading, noises[material.noise].maps[LICHEN_BASE_COLOR]);
#else
  LichenShadingPoint shading = LICHEN_POINT(uv, vec2(0.01, 0.0), vec2(0.0, 0.01));
  vec4 sum = LICHEN_VALUE(LICHEN_BASE_COLOR, shading);
#if (LICHEN_ROLES & 32) != 0
  sum += LICHEN_VALUE(LICHEN_OPACITY, shading);
#endif
#endif
  sum += decode(Noise(vec4(1.0)), tiling(shading.point.tiling.weights, Taps(1.0)));
}
