// SPDX-License-Identifier: MIT
// Any noise, whatever its method: a host places it once per fragment (mapping/) and evaluates each
// of its maps there (lichenValue).
#ifndef LICHEN_METHOD_GLSL
#define LICHEN_METHOD_GLSL

#include "../interface/lichen_interface.h"
#include "surface_texton.glsl"
#include "texton.glsl"
#include "tiling.glsl"

// 0 where no noise is of this method. Literals, or the host's specialization constants. Where
// LICHEN_OMIT_TEXTONS is defined, textons are not called at all, and where
// LICHEN_OMIT_SURFACE_TEXTONS is, those on surfaces are not: some drivers take longer to drop the
// code of a constant that is false than to compile the rest.
#ifdef LICHEN_OMIT_TEXTONS
#define LICHEN_TEXTON_NOISES 0
#ifndef LICHEN_OMIT_SURFACE_TEXTONS
#define LICHEN_OMIT_SURFACE_TEXTONS
#endif
#endif
#ifdef LICHEN_OMIT_SURFACE_TEXTONS
#define LICHEN_SURFACE_TEXTONS 0
#endif
#ifndef LICHEN_TILING_NOISES
#define LICHEN_TILING_NOISES 1
#endif
#ifndef LICHEN_TEXTON_NOISES
#define LICHEN_TEXTON_NOISES 1
#endif
// 0 where no texton noise is mapped onto a surface. Likewise.
#ifndef LICHEN_SURFACE_TEXTONS
#define LICHEN_SURFACE_TEXTONS 1
#endif

/// What all maps of a noise share at one point; the parts of its method and mapping are set.
struct LichenPlace {
  LichenTaps taps;
  LichenImpacts impacts;
  LichenSurfaceImpacts surface;
};

/// Whether this is texton noise; known at compile time where a method is left out.
bool lichenIsTexton(LichenNoise noise) {
  // In variables: of a specialization constant negated here, glslang 11 makes invalid SPIR-V.
  bool hasTexton = bool(LICHEN_TEXTON_NOISES);
  bool hasTiling = bool(LICHEN_TILING_NOISES);
  return hasTexton && (!hasTiling || noise.method == uint(LICHEN_METHOD_TEXTON));
}

/// Whether texton noise is mapped onto a surface; known at compile time where none is.
bool lichenIsSurface(LichenTexton texton) {
  return bool(LICHEN_SURFACE_TEXTONS) && texton.surfaceCubeTexels > 0.0;
}

/// The place at `position` [tiles, relative to the host's integer tile origin] of a pixel with
/// these gradients.
LichenPlace lichenPlaceAt(vec2 position, vec2 gradientX, vec2 gradientY, LichenNoise noise,
                          LichenTexton texton) {
  LichenPlace place;
#ifndef LICHEN_OMIT_TEXTONS
  if (lichenIsTexton(noise))
    place.impacts = lichenImpactsAt(position, gradientX, gradientY, noise, texton);
  else
#endif
    place.taps = lichenTilingTaps(position, gradientX, gradientY, noise);
  return place;
}

/// The value of one map: light for colours, the decoded quantity for the others. Of slopes, z is
/// the variance of a slope that the footprint hides, for lichenRoughness.
vec4 lichenValue(sampler2D image, sampler3D table, LichenPlace place, LichenNoise noise,
                 LichenMap map, LichenTexton texton) {
#ifndef LICHEN_OMIT_SURFACE_TEXTONS
  if (lichenIsTexton(noise) && lichenIsSurface(texton))
    return lichenSurfaceTexton(image, table, place.impacts, place.surface, noise, map, texton);
#endif
#ifndef LICHEN_OMIT_TEXTONS
  if (lichenIsTexton(noise))
    return lichenTexton(image, table, place.impacts, noise, map, texton);
#endif
  return lichenTiling(image, table, place.taps, noise, map);
}

#endif
