// SPDX-License-Identifier: MIT
// Material properties of a surface at a point, from a glTF material and its noise, if it has one.
// The noise replaces the core texture of each channel it provides (that texture is a preview of the
// noise). Other channels use their core textures; factors multiply both.
#ifndef SURFACE_GLSL
#define SURFACE_GLSL

#include "noise_point.glsl"

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

// Whether this pipeline's materials have a normal texture.
layout(constant_id = 1) const bool kHasNormalMap = false;

struct Surface {
  vec4 baseColor;
  vec3 emissive;
  float metallic;
  float roughness; // includes slopeVariance
  float slopeVariance; // along each axis, lost to filtering
  float occlusion;
  vec3 tangentNormal; // in tangent space
  vec3 gradient; // of triplanar and solid slopes, in the world; tangentNormal is then (0, 0, 1)
};

vec4 materialTexture(sampler2D image, int slot, int set, Footprint f) {
  TexturePoint point = texturePoint(slot, set, f);
  return textureGrad(image, point.uv, point.gradients[0], point.gradients[1]);
}

/// The noise's opacity or the texture's alpha, without the factor.
float alphaAt(Footprint f, LICHEN_SHADING_POINT shading) {
  if (NOISE_HAS(LICHEN_OPACITY))
    return NOISE_VALUE(LICHEN_OPACITY, shading).r;
  return materialTexture(baseColorTexture, TEXTURE_BASE_COLOR, material.texCoords.x, f).a;
}

/// Base colour and alpha without the factor.
vec4 baseColorAt(Footprint f, LICHEN_SHADING_POINT shading) {
  bool fromNoise = NOISE_HAS(LICHEN_BASE_COLOR);
  bool alphaIsUsed = material.flags.y != ALPHA_OPAQUE;
  bool opacityFromNoise = alphaIsUsed && NOISE_HAS(LICHEN_OPACITY);
  vec4 color = vec4(1.0);
  if (!fromNoise || (alphaIsUsed && !opacityFromNoise))
    color = materialTexture(baseColorTexture, TEXTURE_BASE_COLOR, material.texCoords.x, f);
  if (fromNoise)
    color.rgb = NOISE_VALUE(LICHEN_BASE_COLOR, shading).rgb;
  if (opacityFromNoise)
    color.a = alphaAt(f, shading);
  return color;
}

vec3 emissiveAt(Footprint f, LICHEN_SHADING_POINT shading) {
  if (NOISE_HAS(LICHEN_EMISSIVE))
    return NOISE_VALUE(LICHEN_EMISSIVE, shading).rgb;
  return materialTexture(emissiveTexture, TEXTURE_EMISSIVE, material.flags.x, f).rgb;
}

/// Occlusion, roughness and metallic, without their factors.
vec3 ormAt(Footprint f, LICHEN_SHADING_POINT shading) {
  vec3 orm;
  orm.x = materialTexture(occlusionTexture, TEXTURE_OCCLUSION, material.texCoords.w, f).r;
  orm.yz = materialTexture(metallicRoughnessTexture, TEXTURE_METALLIC_ROUGHNESS,
                           material.texCoords.y, f)
               .gb;
  if (NOISE_HAS(LICHEN_OCCLUSION_ROUGHNESS_METALLIC))
    orm = NOISE_ORM(shading, orm);
  return orm;
}

/// Transforms a gradient from object to world space, such that the perturbed normal transforms like
/// any normal.
vec3 gradientInWorld(vec3 gradient, Footprint f) {
  vec3 objectNormal = normalize(f.object.normal);
  vec3 along = gradient - dot(gradient, objectNormal) * objectNormal;
  // Three directions determine the linear map from object to world: the two screen-space derivatives [Mikkelsen 2010, Bump Mapping Unparametrized
  // Surfaces on the GPU] and the normal. Its inverse transpose transforms the gradient, which has
  // no component along the normal.
  float volume = dot(cross(f.world.dx, f.world.dy), f.worldOutward);
  if (volume == 0.0)
    return vec3(0.0);
  vec3 inWorld = (dot(along, f.object.dx) * cross(f.world.dy, f.worldOutward) +
                  dot(along, f.object.dy) * cross(f.worldOutward, f.world.dx)) /
                 volume;
  // The normal itself transforms to a vector of length 1 / height.
  vec3 normal = normalize(f.world.normal);
  float height = dot(f.worldOutward, normal);
  float outward = height * dot(inWorld, normal) * (gl_FrontFacing ? 1.0 : -1.0);
  const float kLeastRest = 1e-3; // for a normal that relief almost flips
  return height * inWorld / max(1.0 - outward, kLeastRest);
}

bool hasSlopesInSpace() {
#ifdef WITHOUT_NOISE
  return false;
#else
  return lichenHasSlopesInSpace(lichenMaterial) && NOISE_HAS(LICHEN_NORMAL);
#endif
}

/// xyz: gradient of triplanar and solid slopes; w: slope variance lost to filtering.
vec4 gradientAt(Footprint f, LICHEN_SHADING_POINT shading) {
  if (!hasSlopesInSpace())
    return vec4(0.0);
  float scale = material.factors.z;
  vec4 value = NOISE_VALUE(LICHEN_NORMAL, shading);
  if (isInObject())
    value.xyz = gradientInWorld(value.xyz, f);
  return vec4(scale * value.xyz, scale * scale * value.w);
}

/// xyz: normal in tangent space; w: slope variance lost to filtering. Not for slopes in space.
vec4 tangentNormalAt(Footprint f, LICHEN_SHADING_POINT shading) {
  if (hasSlopesInSpace())
    return vec4(0.0, 0.0, 1.0, 0.0);
#ifndef WITHOUT_NOISE
  if (NOISE_HAS(LICHEN_NORMAL)) {
    float scale = material.factors.z;
    vec3 value = LICHEN_VALUE(LICHEN_NORMAL, shading).xyz;
    vec2 slopes = lichenSlopesToUv(scale * value.xy, lichenMaterial);
    return vec4(lichenNormalFromSlopes(slopes), scale * scale * value.z);
  }
#endif
  if (!kHasNormalMap)
    return vec4(0.0, 0.0, 1.0, 0.0);
  vec3 n = materialTexture(normalTexture, TEXTURE_NORMAL, material.texCoords.z, f).xyz;
  return vec4(normalize((2.0 * n - 1.0) * vec3(material.factors.zz, 1.0)), 0.0);
}

Surface surfaceAt(Footprint f, vec4 vertexColor) {
  LICHEN_SHADING_POINT shading;
  if (kHasNoise)
    shading = noisePoint(f);
  vec3 orm = ormAt(f, shading);
  Surface s;
  s.baseColor = material.baseColor * vertexColor * baseColorAt(f, shading);
  s.emissive = material.emissive.rgb * emissiveAt(f, shading);
  s.occlusion = mix(1.0, orm.x, material.factors.w);
  vec4 normal = tangentNormalAt(f, shading);
  vec4 gradient = gradientAt(f, shading);
  s.roughness = material.factors.y * orm.y;
  s.slopeVariance = max(normal.w + gradient.w, 0.0);
  if (s.slopeVariance > 0.0)
    s.roughness = lichenRoughness(s.roughness, s.slopeVariance);
  s.metallic = material.factors.x * orm.z;
  s.tangentNormal = normal.xyz;
  s.gradient = gradient.xyz;
  return s;
}

#endif
