#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// One trilinear fetch, with the tiling's own texture and sampler: the unit of the ratios.

#define LICHEN_SET 0
#define LICHEN_MAP_COUNT 1
#include "lichen.glsl"

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 colour;

void main() { colour = texture(lichenImage0, uv); }
