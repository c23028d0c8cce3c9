#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// A host's shader for any stage, with its own short names before and after the include.
#define SCALE 2.0
struct Taps { float weight; };
struct Noise { vec4 mean; };
float hash(vec2 p) { return fract(p.x + p.y); }
vec2 uvToTile(vec2 uv) { return SCALE * uv; }
const float gaussian = 0.5;

#include "lichen.glsl"

float tiling(vec3 weights, Taps taps) { return dot(weights, vec3(taps.weight)); }
vec4 decode(Noise noise, float level) { return noise.mean * level; }

void main() {
  vec2 uv = uvToTile(vec2(hash(vec2(gaussian))));
  LichenPlace place = LICHEN_PLACE(uv, vec2(0.01, 0.0), vec2(0.0, 0.01));
  vec4 sum = decode(Noise(vec4(1.0)), tiling(place.taps.point.weights, Taps(1.0)));
  sum += LICHEN_NOISE(0, place);
#if LICHEN_MAP_COUNT == LICHEN_MAX_MAPS
  sum += LICHEN_NOISE(5, place);
#endif
}
