#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Mikkelsen, "Practical Real-Time Hex-Tiling", JCGT 11(3), 2022, the colours of hextile-demo: own
// implementation with the demo's parameters. Strength of rotation 0 and contrast r = 0.7, which are
// parameters at run time; exponent of the weights 7; contrast of the luminance's falloff 0.6.
#include "peer_inputs.glsl"
#include "triangle_grid.glsl"

const float kPi = 3.14159265;

#ifndef PEER_TILE_ROTATION
#define PEER_TILE_ROTATION 1
#endif

mat2 rotationOf(vec2 vertex) {
  float angle = abs(vertex.x * vertex.y) + abs(vertex.x + vertex.y);
  angle = peer.rotationStrength * (mod(angle, 2.0 * kPi) - kPi);
  float c = cos(angle), s = sin(angle);
  return mat2(c, -s, s, c);
}

/// The exemplar in the tile of a vertex, rotated about it.
vec4 tap(vec2 vertex, vec2 dx, vec2 dy) {
  vec2 center = vec2(vertex.x + 0.5 * vertex.y, vertex.y / kSkewY) / kGridScale;
  mat2 rotation = PEER_TILE_ROTATION != 0 ? rotationOf(vertex) : mat2(1.0);
  return textureGrad(exemplar, rotation * (uv - center) + center + hashOf(vertex), rotation * dx,
                     rotation * dy);
}

/// Raises the contrast of weights for r above 1/2, lowers it below.
vec3 gain(vec3 weights, float r) {
  float exponent = log(1.0 - r) / log(0.5);
  vec3 isLarge = 2.0 * step(0.5, weights);
  vec3 slope = 2.0 * (1.0 - isLarge);
  vec3 result =
      0.5 * isLarge + 0.25 * slope * pow(max(vec3(0.0), isLarge + weights * slope), vec3(exponent));
  return result / (result.x + result.y + result.z);
}

void main() {
  const float kExponent = 7.0, kFalloffContrast = 0.6;
  const vec3 kLuminance = vec3(0.299, 0.587, 0.114);
  Triangle triangle = triangleAt(uv);
  vec2 dx = dFdx(uv), dy = dFdy(uv);
  vec4 color1 = tap(triangle.vertex1, dx, dy);
  vec4 color2 = tap(triangle.vertex2, dx, dy);
  vec4 color3 = tap(triangle.vertex3, dx, dy);

  vec3 luminance = kLuminance * mat3(color1.rgb, color2.rgb, color3.rgb);
  vec3 weights =
      mix(vec3(1.0), luminance, kFalloffContrast) * pow(triangle.weights, vec3(kExponent));
  weights /= weights.x + weights.y + weights.z;
  if (peer.contrast != 0.5)
    weights = gain(weights, peer.contrast);
  colour = weights.x * color1 + weights.y * color2 + weights.z * color3;
}
