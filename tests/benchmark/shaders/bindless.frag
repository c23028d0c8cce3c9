#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_nonuniform_qualifier : require
// SPDX-License-Identifier: MIT
// Four layers of a terrain with bindless descriptors, as docs/integration.md has it.
// What the host knows at compile time, as in tiling.frag.
#include "interface/lichen_interface.h"
#define LICHEN_METHODS 1
#define LICHEN_MAPPINGS 1
#define LICHEN_FEATURES (1u | LICHEN_FEATURE_UV | LICHEN_FEATURE_TABLES)
layout(set = 0, binding = 0) uniform sampler imageSampler;
layout(set = 0, binding = 1) uniform sampler tableSampler;
layout(set = 0, binding = 2) uniform texture2D images[];
layout(set = 0, binding = 3) uniform texture3D tables[];
#define LICHEN_IMAGE_2D uint
#define LICHEN_IMAGE_3D uint
#define IMAGE(index) nonuniformEXT(sampler2D(images[index], imageSampler))
#define TABLE(index) nonuniformEXT(sampler3D(tables[index], tableSampler))
#define LICHEN_SAMPLE_2D(image, uv, level) textureLod(IMAGE(image), uv, level)
#define LICHEN_SAMPLE_2D_GRAD(image, uv, uvX, uvY) textureGrad(IMAGE(image), uv, uvX, uvY)
#define LICHEN_SAMPLE_3D(image, uvw, level) textureLod(TABLE(image), uvw, level)
#define LICHEN_FETCH_2D(image, texel) texelFetch(IMAGE(image), texel, 0)
#include "lichen.glsl"

struct Layer {
  LichenMaterial material;
  uint image, table, reserved0, reserved1; // of the base colour
};
layout(std430, set = 0, binding = 4) readonly buffer Noises { LichenNoiseConstants noises[]; };
layout(std430, set = 0, binding = 5) readonly buffer Layers { Layer layers[]; };

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;

void main() {
  uvec4 layerIndices = uvec4(floor(uv.x) * 4.0) % 61u + uvec4(0u, 1u, 2u, 3u); // of this pixel
  vec4 weights = vec4(0.25);
  vec2 dx = dFdx(uv);
  vec2 dy = dFdy(uv);
  color = vec4(0.0);
  for (int k = 0; k < 4; ++k) {
    Layer layer = layers[layerIndices[k]];
    uint noise = layer.material.noise;
    LichenShadingPoint shading = lichenPointUvGrad(uv, dx, dy, layer.material, noises[noise].noise);
    LichenMap map = lichenMapOf(LICHEN_BASE_COLOR, noises[noise].maps[LICHEN_BASE_COLOR]);
    color += weights[k] * lichenValue(layer.image, layer.table, shading, map);
  }
}
