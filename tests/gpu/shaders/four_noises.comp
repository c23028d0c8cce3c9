#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// The base colours of four noises of two methods at a list of points, with descriptors of the
// host's own: images in an array, all noises' constants in one storage buffer, and all materials in
// another. points[k] -> values[4 k ... 4 k + 3].
layout(set = 0, binding = 0) uniform sampler imageSampler;
layout(set = 0, binding = 1) uniform sampler tableSampler;
layout(set = 0, binding = 2) uniform texture2D images[4];
layout(set = 0, binding = 3) uniform texture3D tables[4];
#define LICHEN_IMAGE_2D texture2D
#define LICHEN_IMAGE_3D texture3D
#define LICHEN_SAMPLE_2D(image, uv, level) textureLod(sampler2D(image, imageSampler), uv, level)
#define LICHEN_SAMPLE_2D_GRAD(image, uv, uvX, uvY)                                                 \
  textureGrad(sampler2D(image, imageSampler), uv, uvX, uvY)
#define LICHEN_SAMPLE_3D(image, uvw, level) textureLod(sampler3D(image, tableSampler), uvw, level)
#define LICHEN_GATHER_2D(image, uv) textureGather(sampler2D(image, imageSampler), uv, 0)
#define LICHEN_OMIT_TRIPLANAR
#include "lichen.glsl"

layout(std430, set = 0, binding = 4) readonly buffer Noises { LichenNoiseConstants noises[]; };
layout(std430, set = 0, binding = 5) readonly buffer Materials { LichenMaterial materials[]; };

struct Point {
  vec4 uvAndGradientX;
  vec4 gradientY; // zw unused
};

layout(local_size_x = 64) in;
layout(std430, set = 1, binding = 0) readonly buffer Points { Point points[]; };
layout(std430, set = 1, binding = 1) writeonly buffer Values { vec4 values[]; };

vec4 colorOf(texture2D image, texture3D table, LichenMaterial material, Point point) {
  LichenPlace place = lichenPlaceUvGrad(point.uvAndGradientX.xy, point.uvAndGradientX.zw,
                                        point.gradientY.xy, material, noises[material.noise].noise);
  return lichenValue(image, table, place, noises[material.noise].maps[LICHEN_BASE_COLOR]);
}

void main() {
  uint index = gl_GlobalInvocationID.x;
  if (index >= uint(points.length()))
    return;
  Point point = points[index];
  values[4u * index] = colorOf(images[0], tables[0], materials[0], point);
  values[4u * index + 1u] = colorOf(images[1], tables[1], materials[1], point);
  values[4u * index + 2u] = colorOf(images[2], tables[2], materials[2], point);
  values[4u * index + 3u] = colorOf(images[3], tables[3], materials[3], point);
}
