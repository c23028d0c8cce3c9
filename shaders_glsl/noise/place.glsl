// SPDX-License-Identifier: MIT
// Where a noise is evaluated, whatever its method and mapping: a host places it once per fragment
// (mapping/) and evaluates each of its maps there (lichenValue).
#ifndef LICHEN_PLACE_GLSL
#define LICHEN_PLACE_GLSL

#include "method.glsl"
#include "surface_texton.glsl"
#include "triplanar.glsl"

/// What all maps of a noise share at one place; the parts of its method and mapping are set.
struct LichenPlace {
  LichenMaterial material;
  LichenNoise noise;
  LichenPoint point;
  LichenSurfaceImpacts surface;
  LichenTriplanar triplanar;
};

/// The value of one map: light for colours, the decoded quantity for the others. Of slopes, z is
/// the variance of a slope that the footprint hides, for lichenRoughness; triplanar ones are a
/// gradient in space, and the variance is w.
vec4 lichenValue(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table, LichenPlace place, LichenMap map) {
#ifndef LICHEN_OMIT_TRIPLANAR
  if (lichenIsTriplanar(place.material))
    return lichenTriplanarValue(image, table, place.triplanar, place.point, place.noise, map);
#endif
#ifndef LICHEN_OMIT_SURFACE_TEXTONS
  if (lichenHasMethod(LICHEN_METHOD_TEXTON, place.noise) && lichenIsSurface(place.material))
    return lichenSurfaceTexton(image, table, place.point.texton, place.surface, place.material,
                               place.noise, map);
#endif
  return lichenValueAt(image, table, place.point, place.material, place.noise, map);
}

#endif
