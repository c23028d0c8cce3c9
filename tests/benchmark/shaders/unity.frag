#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Deliot and Heitz, "Procedural Stochastic Textures by Tiling and Blending", GPU Zen 2, 2019, the
// method of Unity's procedural stochastic texturing: own implementation with the authors'
// parameters. Hexagons of half the exemplar's width, a decorrelated colour space whose vectors are
// parameters, Gaussian values of mean 1/2 and deviation 1/6, a table of 128 values per axis with a
// row per mip level. No scales of compressed textures.
#include "peer_inputs.glsl"
#include "triangle_grid.glsl"

void main() {
  Triangle triangle = triangleAt(uv);
  vec2 dx = dFdx(uv), dy = dFdy(uv);
  vec3 weights = triangle.weights;
  vec3 gaussian =
      weights.x * textureGrad(decorrelatedImage, uv + hashOf(triangle.vertex1), dx, dy).rgb +
      weights.y * textureGrad(decorrelatedImage, uv + hashOf(triangle.vertex2), dx, dy).rgb +
      weights.z * textureGrad(decorrelatedImage, uv + hashOf(triangle.vertex3), dx, dy).rgb;
  gaussian = (gaussian - 0.5) * inversesqrt(dot(weights, weights)) + 0.5;

  float row = textureQueryLod(decorrelatedImage, uv).y / float(textureSize(axisTable, 0).y);
  float value1 = texture(axisTable, vec2(gaussian.x, row)).r;
  float value2 = texture(axisTable, vec2(gaussian.y, row)).g;
  float value3 = texture(axisTable, vec2(gaussian.z, row)).b;
  colour = vec4(peer.colorOrigin.rgb + peer.colorAxes[0].rgb * value1 +
                    peer.colorAxes[1].rgb * value2 + peer.colorAxes[2].rgb * value3,
                1.0);
}
