#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// The base colours of four noises of two methods, a column of pixels each in turn, with descriptors
// of the host's own: images in an array, all noises' constants in one storage buffer, and all
// materials in another.
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
#define LICHEN_FETCH_2D(image, texel) texelFetch(sampler2D(image, imageSampler), texel, 0)
#define LICHEN_METHODS 3
#define LICHEN_MAPPINGS 1
#include "lichen.glsl"

layout(std430, set = 0, binding = 4) readonly buffer Noises { LichenNoiseConstants noises[]; };
layout(std430, set = 0, binding = 5) readonly buffer Materials { LichenMaterial materials[]; };

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;

vec4 colorOf(texture2D image, texture3D table, LichenMaterial material) {
  LichenShadingPoint shading =
      lichenPointUvGrad(uv, dFdx(uv), dFdy(uv), material, noises[material.noise].noise);
  return lichenValue(image, table, shading, noises[material.noise].maps[LICHEN_BASE_COLOR]);
}

void main() {
  vec4 weights = vec4(equal(ivec4(int(gl_FragCoord.x) & 3), ivec4(0, 1, 2, 3)));
  color = weights.x * colorOf(images[0], tables[0], materials[0]) +
          weights.y * colorOf(images[1], tables[1], materials[1]) +
          weights.z * colorOf(images[2], tables[2], materials[2]) +
          weights.w * colorOf(images[3], tables[3], materials[3]);
}
