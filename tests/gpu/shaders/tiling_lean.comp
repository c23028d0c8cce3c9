#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// The first map of a tiling noise by tiling.glsl and decode.glsl alone, without the options:
// points[k] (uv and its gradients) -> values[k].
#include "noise/decode.glsl"
#include "noise/tiling.glsl"

layout(std140, set = 0, binding = LICHEN_BINDING_NOISE) uniform Block {
  LichenNoise noise;
  LichenMap maps[LICHEN_MAX_MAPS];
  LichenTexton texton;
} uniforms;
layout(set = 0, binding = LICHEN_BINDING_IMAGE(0)) uniform sampler2D gaussianImage;
layout(set = 0, binding = LICHEN_BINDING_TABLE(0)) uniform sampler3D inverseTable;

const int kDecoded = 0;
const int kGaussian = 3; // as in tiling_evaluate.comp
layout(constant_id = 0) const int kQuantity = kDecoded;

struct Point {
  vec4 uvAndGradientX;
  vec4 gradientY; // zw unused
};

layout(local_size_x = 64) in;
layout(std430, set = 1, binding = 0) readonly buffer Points { Point points[]; };
layout(std430, set = 1, binding = 1) writeonly buffer Values { vec4 values[]; };

void main() {
  uint index = gl_GlobalInvocationID.x;
  if (index >= uint(points.length()))
    return;
  Point point = points[index];
  LichenNoise noise = uniforms.noise;
  LichenMap map = uniforms.maps[0];
  mat2 toTile = mat2(noise.uvToTileXX, noise.uvToTileYX, noise.uvToTileXY, noise.uvToTileYY);
  vec2 position = toTile * point.uvAndGradientX.xy + vec2(noise.offsetX, noise.offsetY);
  LichenTilingPoint at = lichenTilingPoint(position, toTile * point.uvAndGradientX.zw,
                                           toTile * point.gradientY.xy, noise);
  vec4 gaussian = lichenTilingGaussian(gaussianImage, at, noise, map);
  values[index] =
      kQuantity == kGaussian
          ? gaussian
          : lichenDecode(inverseTable, gaussian.rgb, gaussian.a, noise.contrast, map);
}
