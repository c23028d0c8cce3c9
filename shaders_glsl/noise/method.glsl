// SPDX-License-Identifier: MIT
// Any noise, whatever its method: a host places it once per fragment (mapping/) and evaluates each
// of its maps there (lichenValue).
#ifndef LICHEN_METHOD_GLSL
#define LICHEN_METHOD_GLSL

#include "../interface/lichen_interface.h"
#include "method_choice.glsl"
#include "surface_texton.glsl"
#include "texton.glsl"
#include "tiling_options.glsl"
#include "triplanar.glsl"

/// What all maps of a noise share at one point; the parts of its method and mapping are set.
struct LichenPlace {
  LichenTilingTaps taps;
  LichenImpacts impacts;
  LichenSurfaceImpacts surface;
  LichenTriplanar triplanar;
};

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
/// the variance of a slope that the footprint hides, for lichenRoughness; triplanar ones are a
/// gradient in space, and the variance is w.
vec4 lichenValue(sampler2D image, sampler3D table, LichenPlace place, LichenNoise noise,
                 LichenMap map, LichenTexton texton) {
#ifndef LICHEN_OMIT_TRIPLANAR
  if (lichenIsTriplanar(noise))
    return lichenTriplanarValue(image, table, place.triplanar, place.impacts.mixWeight, noise, map,
                                texton);
#endif
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
