// SPDX-License-Identifier: MIT
// The weight of a mix as a point of any noise carries it: what a material and texture coordinates
// say of it. Only textons are mixed.
#ifndef LICHEN_MIX_POINT_GLSL
#define LICHEN_MIX_POINT_GLSL

#include "method.glsl"

/// From texture coordinates: a constant or a direction.
void lichenSetMixFromUv(LICHEN_INOUT(LichenPoint) point, vec2 uv, LichenMaterial material,
                        LichenNoise noise) {
#ifdef LICHEN_HAS_TEXTONS
  if (lichenHasMethod(LICHEN_METHOD_TEXTON, noise) && lichenIsMix(noise))
    lichenSetMix(point.texton, lichenMixWeight(uv, material), lichenMixGradient(material));
#endif
}

/// Without texture coordinates: right for a constant. For a direction a host sets it:
/// lichenSetMix(shading.point.texton, lichenMixWeight(uv, material), vec2(0.0)).
void lichenSetMixFromMaterial(LICHEN_INOUT(LichenPoint) point, LichenMaterial material,
                              LichenNoise noise) {
#ifdef LICHEN_HAS_TEXTONS
  if (lichenHasMethod(LICHEN_METHOD_TEXTON, noise))
    point.texton.mixWeight = lichenTextonMaterial(material).mixWeight;
#endif
}

/// From another point.
void lichenCopyMix(LICHEN_INOUT(LichenPoint) point, LichenPoint other) {
#ifdef LICHEN_HAS_TEXTONS
  point.texton.mixWeight = other.texton.mixWeight;
#endif
}

#endif
