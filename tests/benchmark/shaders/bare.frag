#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Three fetches with explicit derivatives and nothing else: the floor of every method that blends
// three tiles.
#include "peer_inputs.glsl"

void main() {
  const vec2 kOffset1 = vec2(0.25, 0.5), kOffset2 = vec2(0.75, 0.125), kOffset3 = vec2(0.375, 0.875);
  vec2 dx = dFdx(uv), dy = dFdy(uv);
  colour = (textureGrad(exemplar, uv + kOffset1, dx, dy) +
            textureGrad(exemplar, uv + kOffset2, dx, dy) +
            textureGrad(exemplar, uv + kOffset3, dx, dy)) / 3.0;
}
