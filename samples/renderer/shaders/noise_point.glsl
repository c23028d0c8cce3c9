// SPDX-License-Identifier: MIT
// The descriptors of a material and its noise, and where to evaluate that: the same for fragments
// and for displaced vertices.
#ifndef NOISE_POINT_GLSL
#define NOISE_POINT_GLSL

// What lichenGetShaderSwitches says of the noises.
layout(constant_id = 3) const uint kFeatures = 0xFFFFFFFFu;
layout(constant_id = 4) const int kRoles = 63;
layout(constant_id = 5) const bool kObjectSpaces = true; // whether any noise is in object space
#define LICHEN_FEATURES kFeatures
#define LICHEN_ROLES kRoles
#include "scene_interface.h"
// WITHOUT_NOISE: the material has none, and nothing is bound to the set.
#ifdef WITHOUT_NOISE
const bool kHasNoise = false;
#define NOISE_HAS(role) false
#define NOISE_VALUE(role, shading) vec4(0.0)
#define NOISE_ORM(shading, absent) absent
#define LICHEN_SHADING_POINT LichenShadingPoint
#include "lichen.glsl"
#else
const bool kHasNoise = true;
#define NOISE_HAS(role) LICHEN_HAS(role)
#define NOISE_VALUE(role, shading) LICHEN_VALUE(role, shading)
#define NOISE_ORM(shading, absent) LICHEN_ORM(shading, absent)
#define LICHEN_SET SET_NOISE
#include "lichen.glsl"
#endif

layout(std140, set = SET_MATERIAL, binding = BINDING_MATERIAL) uniform MaterialBlock {
  MaterialData material;
};
layout(set = SET_MATERIAL, binding = BINDING_TEXTURES + TEXTURE_MIX)
    uniform sampler2D mixTexture;

/// A surface point in world or object space.
struct Spot {
  vec3 position;
  vec3 dx, dy; // screen-space derivatives of position, scaled for averaging frames
  vec3 normal; // of the front face, not normalised
  vec4 tangent;
};

struct Footprint {
  vec4 texCoords; // two sets
  vec4 dx; // screen-space derivatives, scaled in the same way
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

#if !defined(WITHOUT_NOISE) && LICHEN_LAYERS == 1
/// The weight in a mask, at an offset from a point.
float mixMask(TexturePoint point, vec2 offset) {
  vec4 value =
      textureGrad(mixTexture, point.uv + offset, point.gradients[0], point.gradients[1]);
  return value[material.mixSource.z];
}

/// Sets the weight of a mix whose source is not the uniform block. The gradients of the tile
/// coordinate are 0 if there is none: with surface mapping, all impacts use the weight at the
/// point.
void setMix(inout LichenPoint point, Footprint f, mat2 tileGradients) {
  if (material.mixSource.x == MIX_FROM_VERTICES)
    lichenSetMix(point, f.mixWeight, vec2(0.0));
  if (material.mixSource.x != MIX_FROM_MASK)
    return;
  TexturePoint mask = texturePoint(TEXTURE_MIX, material.mixSource.y, f);
  mat2 reach = lichenMaskReach(mask.gradients, tileGradients, lichenNoise);
  vec2 differences = vec2(mixMask(mask, reach[0]) - mixMask(mask, -reach[0]),
                          mixMask(mask, reach[1]) - mixMask(mask, -reach[1]));
  lichenMixByMask(point, mixMask(mask, vec2(0.0)), differences, lichenNoise);
}

/// Sets the weight of a mix for triplanar and surface mapping, which may still be mixed by texture
/// coordinates.
void setMixInSpace(inout LichenPoint point, Footprint f, vec2 uv) {
  if (!lichenHasMethod(LICHEN_METHOD_TEXTON, lichenNoise) || !lichenIsMix(lichenNoise))
    return;
  // For the sources direction and constant.
  lichenSetMix(point, lichenMixWeight(uv, lichenMaterial), vec2(0.0));
  setMix(point, f, mat2(0.0));
}
#endif

bool isInObject() { return kObjectSpaces && material.mixSource.w != 0; }

/// Where to evaluate the noise; shared by all its maps.
LICHEN_SHADING_POINT noisePoint(Footprint f) {
#ifdef WITHOUT_NOISE
  LichenShadingPoint nowhere;
  return nowhere;
#else
  bool second = material.flags.w != 0;
  vec2 uv = second ? f.texCoords.zw : f.texCoords.xy;
  vec2 dx = second ? f.dx.zw : f.dx.xy;
  vec2 dy = second ? f.dy.zw : f.dy.xy;
  Spot spot = f.world;
  if (isInObject())
    spot = f.object;
  spot.position += material.fromTileOrigin.xyz; // 0 in object space
#if LICHEN_LAYERS > 1
  return LICHEN_POINT_ANYWHERE(uv, dx, dy, spot.position, spot.dx, spot.dy, spot.normal);
#else
#if LICHEN_HAS_TRIPLANAR
  if (lichenIsTriplanar(lichenMaterial)) {
    LichenShadingPoint shading =
        LICHEN_POINT_TRIPLANAR(spot.position, spot.dx, spot.dy, spot.normal);
    setMixInSpace(shading.point, f, uv);
    return shading;
  }
#endif
#if LICHEN_HAS_SURFACES
  if (lichenIsSurface(lichenMaterial)) {
    LichenShadingPoint shading =
        LICHEN_POINT_SURFACE(spot.position, spot.dx, spot.dy, spot.normal, spot.tangent);
    setMixInSpace(shading.point, f, uv);
    return shading;
  }
#endif
#if LICHEN_HAS_SOLIDS
  if (lichenIsSolid(lichenMaterial))
    return LICHEN_POINT_SOLID(spot.position, spot.dx, spot.dy);
#endif
  LichenShadingPoint shading = LICHEN_POINT(uv, dx, dy);
  if (lichenHasMethod(LICHEN_METHOD_TEXTON, lichenNoise) && lichenIsMix(lichenNoise))
    setMix(shading.point, f,
           mat2(lichenUvToTile(dx, lichenMaterial), lichenUvToTile(dy, lichenMaterial)));
  return shading;
#endif
#endif
}

#endif
