// SPDX-License-Identifier: MIT
// Material properties of a surface at a point, from a glTF material and its noise, if it has one.
// The noise replaces the core texture of each channel it provides (that texture is a preview of the
// noise). Other channels use their core textures; factors multiply both.
#ifndef SURFACE_GLSL
#define SURFACE_GLSL

// Whether any map of a noise but textons has no table; bits of the methods that noises have.
layout(constant_id = 3) const bool kGaussianOnly = true;
layout(constant_id = 4) const int kMethods = 7;
layout(constant_id = 5) const bool kMixedTextons = true; // whether any is a mix
layout(constant_id = 6) const bool kTriplanar = true; // whether any uses triplanar mapping
layout(constant_id = 7) const bool kOtherMappings = true; // whether any uses another mapping
layout(constant_id = 8) const bool kObjectSpaces = true; // whether any is in object space
layout(constant_id = 9) const bool kTileRotation = true; // whether any rotates its tiles
#define LICHEN_USED_METHODS kMethods
#ifndef LICHEN_OMIT_TRIPLANAR
#define LICHEN_TRIPLANAR kTriplanar
#define LICHEN_OTHER_MAPPINGS kOtherMappings
#endif
#define LICHEN_MIXED_TEXTONS kMixedTextons
#define LICHEN_TILE_ROTATION kTileRotation
#define LICHEN_GAUSSIAN_ONLY kGaussianOnly
#include "scene_interface.h"
// WITHOUT_NOISE: the material has none, and nothing is bound to the set.
#ifdef WITHOUT_NOISE
const bool kHasNoise = false;
#define NOISE_HAS(role) false
#define NOISE_VALUE(role, shading) vec4(0.0)
#define NOISE_ORM(shading, absent) absent
#include "lichen.glsl"
#else
const bool kHasNoise = true;
#define NOISE_HAS(role) LICHEN_HAS(role)
#define NOISE_VALUE(role, shading) LICHEN_VALUE(role, shading)
#define NOISE_ORM(shading, absent) LICHEN_ORM(shading, absent)
#define LICHEN_SET SET_NOISE
#define LICHEN_ROLES 47 // all but height: this renderer does not displace surfaces
#include "lichen.glsl"
#endif

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
layout(set = SET_MATERIAL, binding = BINDING_TEXTURES + TEXTURE_MIX)
    uniform sampler2D mixTexture;

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
  vec3 gradient; // gradient of triplanar slopes, in the world; tangentNormal is then (0, 0, 1)
};

/// A surface point in world or object space.
struct Spot {
  vec3 position;
  vec3 dx, dy; // screen-space derivatives of position, scaled for averaging frames
  vec3 normal; // of the front face, not normalised
  vec4 tangent;
};

struct Footprint {
  vec4 texCoords; // two sets
  vec4 dx; // screen-space derivatives, scaled likewise
  vec4 dy;
  Spot world;
  Spot object; // unset if kObjectSpaces is false, like worldOutward
  vec3 worldOutward; // a unit step along the object's normal, in the world
  float mixWeight; // from the vertices
};

/// A texture's transformed coordinates and, as columns, their gradients.
struct TexturePoint {
  vec2 uv;
  mat2 gradients;
};

TexturePoint texturePoint(int slot, int set, Footprint f) {
  vec2 uv = set == 0 ? f.texCoords.xy : f.texCoords.zw;
  vec2 dx = set == 0 ? f.dx.xy : f.dx.zw;
  vec2 dy = set == 0 ? f.dy.xy : f.dy.zw;
  vec3 row0 = material.transformRows[2 * slot].xyz;
  vec3 row1 = material.transformRows[2 * slot + 1].xyz;
  mat2 linear = mat2(row0.x, row1.x, row0.y, row1.y);
  return TexturePoint(linear * uv + vec2(row0.z, row1.z), linear * mat2(dx, dy));
}

vec4 materialTexture(sampler2D image, int slot, int set, Footprint f) {
  TexturePoint point = texturePoint(slot, set, f);
  return textureGrad(image, point.uv, point.gradients[0], point.gradients[1]);
}

#ifndef WITHOUT_NOISE
/// The weight in a mask, at an offset from a point.
float mixMask(TexturePoint point, vec2 offset) {
  vec4 value =
      textureGrad(mixTexture, point.uv + offset, point.gradients[0], point.gradients[1]);
  return value[material.mixSource.z];
}

/// Sets the weight of a mix whose source is not the uniform block. The gradients of the tile
/// coordinate are 0 if there is none: with surface mapping, all impacts use the weight at the
/// point.
void setMix(inout LichenImpacts impacts, Footprint f, mat2 tileGradients) {
  if (material.mixSource.x == MIX_FROM_VERTICES)
    lichenSetMix(impacts, f.mixWeight, vec2(0.0));
  if (material.mixSource.x != MIX_FROM_MASK)
    return;
  TexturePoint mask = texturePoint(TEXTURE_MIX, material.mixSource.y, f);
  mat2 reach = lichenMaskReach(mask.gradients, tileGradients, lichenNoise);
  vec2 differences = vec2(mixMask(mask, reach[0]) - mixMask(mask, -reach[0]),
                          mixMask(mask, reach[1]) - mixMask(mask, -reach[1]));
  lichenMixByMask(impacts, mixMask(mask, vec2(0.0)), differences, lichenNoise);
}

/// Sets the weight of a mix for triplanar and surface mapping, which may still be mixed by texture
/// coordinates.
void setMixInSpace(inout LichenPoint point, Footprint f, vec2 uv) {
#ifdef LICHEN_HAS_TEXTONS
  if (!lichenHasMethod(LICHEN_METHOD_TEXTON, lichenNoise) || !lichenIsMix(lichenNoise))
    return;
  // For the sources direction and constant.
  lichenSetMix(point.texton, lichenMixWeight(uv, lichenMaterial), vec2(0.0));
  setMix(point.texton, f, mat2(0.0));
#endif
}
#endif

bool isInObject() { return kObjectSpaces && material.mixSource.w != 0; }

/// Where to evaluate the noise; shared by all its maps.
LichenShadingPoint noisePoint(Footprint f) {
#ifdef WITHOUT_NOISE
  LichenShadingPoint nowhere;
  return nowhere;
#else
  bool second = material.flags.w != 0;
  vec2 uv = second ? f.texCoords.zw : f.texCoords.xy;
#if !defined(LICHEN_OMIT_TRIPLANAR) || !defined(LICHEN_OMIT_SURFACE_TEXTONS)
  Spot spot = f.world;
  if (isInObject())
    spot = f.object;
  spot.position += material.fromTileOrigin.xyz; // 0 in object space
#endif
#ifndef LICHEN_OMIT_TRIPLANAR
  if (lichenIsTriplanar(lichenMaterial)) {
    LichenShadingPoint shading =
        LICHEN_POINT_TRIPLANAR(spot.position, spot.dx, spot.dy, spot.normal);
    setMixInSpace(shading.point, f, uv);
    return shading;
  }
#endif
#ifndef LICHEN_OMIT_SURFACE_TEXTONS
  if (lichenHasMethod(LICHEN_METHOD_TEXTON, lichenNoise) && lichenIsSurface(lichenMaterial)) {
    LichenShadingPoint shading =
        LICHEN_POINT_SURFACE(spot.position, spot.dx, spot.dy, spot.normal, spot.tangent);
    setMixInSpace(shading.point, f, uv);
    return shading;
  }
#endif
  vec2 dx = second ? f.dx.zw : f.dx.xy;
  vec2 dy = second ? f.dy.zw : f.dy.xy;
  LichenShadingPoint shading = LICHEN_POINT(uv, dx, dy);
#ifdef LICHEN_HAS_TEXTONS
  if (lichenHasMethod(LICHEN_METHOD_TEXTON, lichenNoise) && lichenIsMix(lichenNoise))
    setMix(shading.point.texton, f,
           mat2(lichenUvToTile(dx, lichenMaterial), lichenUvToTile(dy, lichenMaterial)));
#endif
  return shading;
#endif
}

/// The noise's opacity or the texture's alpha, without the factor.
float alphaAt(Footprint f, LichenShadingPoint shading) {
  if (NOISE_HAS(LICHEN_OPACITY))
    return NOISE_VALUE(LICHEN_OPACITY, shading).r;
  return materialTexture(baseColorTexture, TEXTURE_BASE_COLOR, material.texCoords.x, f).a;
}

/// Base colour and alpha without the factor.
vec4 baseColorAt(Footprint f, LichenShadingPoint shading) {
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

vec3 emissiveAt(Footprint f, LichenShadingPoint shading) {
  if (NOISE_HAS(LICHEN_EMISSIVE))
    return NOISE_VALUE(LICHEN_EMISSIVE, shading).rgb;
  return materialTexture(emissiveTexture, TEXTURE_EMISSIVE, material.flags.x, f).rgb;
}

/// Occlusion, roughness and metallic, without their factors.
vec3 ormAt(Footprint f, LichenShadingPoint shading) {
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
  // Three directions determine the local linear map from object to world, including node, morph
  // targets and skin: the two screen-space derivatives [Mikkelsen 2010, Bump Mapping Unparametrized
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

bool hasTriplanarSlopes() {
#ifdef WITHOUT_NOISE
  return false;
#else
  return lichenIsTriplanar(lichenMaterial) && LICHEN_HAS(LICHEN_NORMAL);
#endif
}

/// xyz: gradient of triplanar slopes; w: slope variance lost to filtering.
vec4 gradientAt(Footprint f, LichenShadingPoint shading) {
  if (!hasTriplanarSlopes())
    return vec4(0.0);
  float scale = material.factors.z;
  vec4 value = NOISE_VALUE(LICHEN_NORMAL, shading);
  if (isInObject())
    value.xyz = gradientInWorld(value.xyz, f);
  return vec4(scale * value.xyz, scale * scale * value.w);
}

/// xyz: normal in tangent space; w: slope variance lost to filtering. Not for triplanar slopes.
vec4 tangentNormalAt(Footprint f, LichenShadingPoint shading) {
  if (hasTriplanarSlopes())
    return vec4(0.0, 0.0, 1.0, 0.0);
#ifndef WITHOUT_NOISE
  if (LICHEN_HAS(LICHEN_NORMAL)) {
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
  LichenShadingPoint shading;
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
