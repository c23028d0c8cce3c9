#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// One map of a tiling noise by tiling.glsl and tiling_decode.glsl alone, without the options, as a host
// with descriptors of its own calls them: points[k] (uv and its gradients) -> values[k].
#include "interface/lichen_interface.h"

layout(set = 0, binding = LICHEN_BINDING_IMAGE_SAMPLER) uniform sampler imageSampler;
layout(set = 0, binding = LICHEN_BINDING_TABLE_SAMPLER) uniform sampler tableSampler;
#define LICHEN_IMAGE_2D texture2D
#define LICHEN_IMAGE_3D texture3D
#define LICHEN_SAMPLE_2D(image, uv, level) textureLod(sampler2D(image, imageSampler), uv, level)
#define LICHEN_SAMPLE_2D_GRAD(image, uv, uvX, uvY)                                                 \
  textureGrad(sampler2D(image, imageSampler), uv, uvX, uvY)
#define LICHEN_SAMPLE_3D(image, uvw, level) textureLod(sampler3D(image, tableSampler), uvw, level)
#define LICHEN_FETCH_2D(image, texel) texelFetch(sampler2D(image, imageSampler), texel, 0)
#define LICHEN_GATHER_2D(image, uv) textureGather(sampler2D(image, imageSampler), uv, 0)
#include "noise/tiling.glsl"
#include "noise/tiling_decode.glsl"

layout(std140, set = 0, binding = LICHEN_BINDING_NOISE) uniform NoiseBlock {
  LichenNoiseConstants constants;
};
layout(std140, set = 0, binding = LICHEN_BINDING_MATERIAL) uniform MaterialBlock {
  LichenMaterial material;
};
// The roles of synthetic maps.
layout(set = 0, binding = LICHEN_BINDING_IMAGE(LICHEN_BASE_COLOR)) uniform texture2D colorImage;
layout(set = 0, binding = LICHEN_BINDING_TABLE(LICHEN_BASE_COLOR)) uniform texture3D colorTable;
layout(set = 0, binding = LICHEN_BINDING_IMAGE(LICHEN_NORMAL)) uniform texture2D slopeImage;
layout(set = 0, binding = LICHEN_BINDING_TABLE(LICHEN_NORMAL)) uniform texture3D slopeTable;
layout(set = 0, binding = LICHEN_BINDING_IMAGE(LICHEN_HEIGHT)) uniform texture2D heightImage;
layout(set = 0, binding = LICHEN_BINDING_TABLE(LICHEN_HEIGHT)) uniform texture3D heightTable;
layout(set = 0, binding = LICHEN_BINDING_IMAGE(LICHEN_OCCLUSION_ROUGHNESS_METALLIC)) uniform
    texture2D ormImage;
layout(set = 0, binding = LICHEN_BINDING_TABLE(LICHEN_OCCLUSION_ROUGHNESS_METALLIC)) uniform
    texture3D ormTable;

const int kDecoded = 0;
const int kGaussian = 1; // as in tiling_evaluate.comp
layout(constant_id = 0) const int kQuantity = kDecoded;
layout(constant_id = 1) const int kRole = LICHEN_BASE_COLOR;

struct Point {
  vec4 uvAndGradientX;
  vec4 gradientY; // zw unused
};

layout(local_size_x = 64) in;
layout(std430, set = 1, binding = 0) readonly buffer Points { Point points[]; };
layout(std430, set = 1, binding = 1) writeonly buffer Values { vec4 values[]; };

vec4 evaluated(texture2D image, texture3D table, Point point) {
  LichenMap map = constants.maps[kRole];
  mat2 toTile =
      mat2(material.uvToTileXX, material.uvToTileYX, material.uvToTileXY, material.uvToTileYY);
  vec2 position = toTile * point.uvAndGradientX.xy + vec2(material.offsetX, material.offsetY);
  LichenTilingPoint at =
      lichenTilingPoint(position, toTile * point.uvAndGradientX.zw, toTile * point.gradientY.xy,
                        material, constants.noise);
  vec4 gaussian = lichenTilingGaussian(image, at, map);
  float lossShare = lichenTilingLossShare(at, map);
  return kQuantity == kGaussian
             ? vec4(gaussian.rgb, gaussian.a * lossShare)
             : lichenTilingDecode(table, gaussian, lossShare, material.contrast, map);
}

void main() {
  uint index = gl_GlobalInvocationID.x;
  if (index >= uint(points.length()))
    return;
  if (kRole == LICHEN_BASE_COLOR)
    values[index] = evaluated(colorImage, colorTable, points[index]);
  else if (kRole == LICHEN_NORMAL)
    values[index] = evaluated(slopeImage, slopeTable, points[index]);
  else if (kRole == LICHEN_OCCLUSION_ROUGHNESS_METALLIC)
    values[index] = evaluated(ormImage, ormTable, points[index]);
  else
    values[index] = evaluated(heightImage, heightTable, points[index]);
}
