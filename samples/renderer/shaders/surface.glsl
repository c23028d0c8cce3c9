// SPDX-License-Identifier: MIT
// What a surface is made of at a point, from a glTF material and, where it has one, its noise.
#ifndef SURFACE_GLSL
#define SURFACE_GLSL

#include "lichen.glsl"
#include "scene_interface.h"

layout(std140, set = SET_MATERIAL, binding = BINDING_MATERIAL) uniform MaterialBlock {
  MaterialData material;
};
layout(set = SET_MATERIAL, binding = BINDING_TEXTURES + TEXTURE_BASE_COLOR)
    uniform sampler2D baseColorTexture;
layout(set = SET_MATERIAL, binding = BINDING_TEXTURES + TEXTURE_METALLIC_ROUGHNESS)
    uniform sampler2D metallicRoughnessTexture;
layout(set = SET_MATERIAL, binding = BINDING_TEXTURES + TEXTURE_NORMAL)
    uniform sampler2D normalTexture;
layout(set = SET_MATERIAL, binding = BINDING_TEXTURES + TEXTURE_OCCLUSION)
    uniform sampler2D occlusionTexture;
layout(set = SET_MATERIAL, binding = BINDING_TEXTURES + TEXTURE_EMISSIVE)
    uniform sampler2D emissiveTexture;

layout(std140, set = SET_NOISE, binding = BINDING_NOISE) uniform NoiseBlock {
  LichenNoise noise;
  LichenMap maps[LICHEN_MAX_MAPS];
} noiseData;
#define NOISE_SAMPLERS(role, name)                                                                 \
  layout(set = SET_NOISE, binding = BINDING_NOISE_ROLES + 2 * role)                                \
      uniform sampler2D name##Gaussian;                                                            \
  layout(set = SET_NOISE, binding = BINDING_NOISE_ROLES + 2 * role + 1)                            \
      uniform sampler3D name##Table
NOISE_SAMPLERS(NOISE_BASE_COLOR, baseColor);
NOISE_SAMPLERS(NOISE_NORMAL, normal);
NOISE_SAMPLERS(NOISE_ORM, orm);
NOISE_SAMPLERS(NOISE_EMISSIVE, emissive);

// The noise of this pipeline's materials, and whether anything samples their textures.
layout(constant_id = 0) const bool kHasNoise = false;
layout(constant_id = 1) const bool kHasNormalMap = false;

struct Surface {
  vec4 baseColor;
  vec3 emissive;
  float metallic;
  float roughness;
  float occlusion;
  vec3 tangentNormal; // in tangent space
};

struct Footprint {
  vec4 texCoords; // two sets
  vec4 dx;        // their screen-space gradients, scaled for averaging frames
  vec4 dy;
};

vec4 materialTexture(sampler2D image, int slot, int set, Footprint f) {
  vec2 uv = set == 0 ? f.texCoords.xy : f.texCoords.zw;
  vec2 dx = set == 0 ? f.dx.xy : f.dx.zw;
  vec2 dy = set == 0 ? f.dy.xy : f.dy.zw;
  vec3 row0 = material.transformRows[2 * slot].xyz;
  vec3 row1 = material.transformRows[2 * slot + 1].xyz;
  mat2 linear = mat2(row0.x, row1.x, row0.y, row1.y);
  return textureGrad(image, linear * uv + vec2(row0.z, row1.z), linear * dx, linear * dy);
}

/// Taps of the noise, which all its maps share.
LichenTaps noiseTaps(Footprint f) {
  bool second = material.flags.w != 0;
  return lichenTilingUvGrad(second ? f.texCoords.zw : f.texCoords.xy, second ? f.dx.zw : f.dx.xy,
                            second ? f.dy.zw : f.dy.xy, noiseData.noise);
}

#define NOISE_VALUE(role, name, taps)                                                              \
  lichenTiling(name##Gaussian, name##Table, taps, noiseData.noise,                                 \
               noiseData.maps[material.noiseMaps[role]])

/// Replaces what the noise has; core factors multiply it as they multiply a texture.
void applyNoise(inout Surface surface, LichenTaps taps) {
  if (material.noiseMaps[NOISE_BASE_COLOR] >= 0)
    surface.baseColor.rgb *= NOISE_VALUE(NOISE_BASE_COLOR, baseColor, taps).rgb;
  if (material.noiseMaps[NOISE_NORMAL] >= 0) {
    vec2 slopes = material.factors.z * NOISE_VALUE(NOISE_NORMAL, normal, taps).xy;
    surface.tangentNormal = lichenNormalFromSlopes(lichenSlopesToUv(slopes, noiseData.noise));
  }
  if (material.noiseMaps[NOISE_ORM] >= 0) {
    vec3 value = NOISE_VALUE(NOISE_ORM, orm, taps).rgb;
    ivec3 component = material.ormComponents.xyz;
    if (component.x >= 0)
      surface.occlusion = mix(1.0, value[component.x], material.factors.w);
    if (component.y >= 0)
      surface.roughness *= value[component.y];
    if (component.z >= 0)
      surface.metallic *= value[component.z];
  }
  if (material.noiseMaps[NOISE_EMISSIVE] >= 0)
    surface.emissive *= NOISE_VALUE(NOISE_EMISSIVE, emissive, taps).rgb;
}

Surface surfaceAt(Footprint f, vec4 vertexColor) {
  Surface s;
  s.baseColor = material.baseColor * vertexColor;
  s.emissive = material.emissive.rgb;
  s.metallic = material.factors.x;
  s.roughness = material.factors.y;
  s.occlusion = 1.0;
  s.tangentNormal = vec3(0.0, 0.0, 1.0);
  if (kHasNoise) {
    // The core textures hold the noise's preview: a viewer shows one or the other.
    applyNoise(s, noiseTaps(f));
    return s;
  }
  s.baseColor *= materialTexture(baseColorTexture, TEXTURE_BASE_COLOR, material.texCoords.x, f);
  s.emissive *=
      materialTexture(emissiveTexture, TEXTURE_EMISSIVE, material.flags.x, f).rgb;
  vec2 roughnessMetallic = materialTexture(metallicRoughnessTexture, TEXTURE_METALLIC_ROUGHNESS,
                                           material.texCoords.y, f).gb;
  s.roughness *= roughnessMetallic.x;
  s.metallic *= roughnessMetallic.y;
  float occlusion =
      materialTexture(occlusionTexture, TEXTURE_OCCLUSION, material.texCoords.w, f).r;
  s.occlusion = mix(1.0, occlusion, material.factors.w);
  if (kHasNormalMap) {
    vec3 n = materialTexture(normalTexture, TEXTURE_NORMAL, material.texCoords.z, f).xyz;
    s.tangentNormal = normalize((2.0 * n - 1.0) * vec3(material.factors.zz, 1.0));
  }
  return s;
}

#endif
