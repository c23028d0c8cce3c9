#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Heitz and Neyret, "High-Performance By-Example Noise using a Histogram-Preserving Blending
// Operator", 2018, Algorithm 1: own implementation with the paper's parameters. Hexagons of half
// the exemplar's width, a Gaussian image of mean 1/2 and deviation 1/6, a table of 32^3 colours
// without prefilter. The hash is that of the authors' later publication. Equation 22 divides by 6
// where the deviation is 1/6: it must multiply.
#include "peer_inputs.glsl"
#include "triangle_grid.glsl"

/// Abramowitz and Stegun, Handbook of Mathematical Functions, 7.1.26: absolute error 1.5e-7.
vec3 errorFunction(vec3 x) {
  vec3 t = 1.0 / (1.0 + 0.3275911 * abs(x));
  vec3 tail =
      t * (0.254829592 +
           t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429))));
  return sign(x) * (1.0 - tail * exp(-x * x));
}

void main() {
  const float kDeviation = 1.0 / 6.0;
  const float kSqrt2 = 1.41421356;
  Triangle triangle = triangleAt(uv);
  vec2 dx = dFdx(uv), dy = dFdy(uv);
  vec3 weights = triangle.weights;
  vec3 gaussian =
      weights.x * textureGrad(gaussianImage, uv + hashOf(triangle.vertex1), dx, dy).rgb +
      weights.y * textureGrad(gaussianImage, uv + hashOf(triangle.vertex2), dx, dy).rgb +
      weights.z * textureGrad(gaussianImage, uv + hashOf(triangle.vertex3), dx, dy).rgb;
  gaussian = (gaussian - 0.5) / sqrt(dot(weights, weights)) + 0.5; // equation 13
  vec3 uniformValue = 0.5 + 0.5 * errorFunction((gaussian - 0.5) / (kDeviation * kSqrt2)); // 22
  colour = textureLod(colorTable, uniformValue, 0.0);
}
