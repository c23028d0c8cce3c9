#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// One trilinear fetch: the unit of the ratios.
#include "peer_inputs.glsl"

void main() { colour = texture(exemplar, uv); }
