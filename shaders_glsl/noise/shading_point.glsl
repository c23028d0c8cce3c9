// SPDX-License-Identifier: MIT
// A point where a noise is evaluated, whatever its method and mapping: a host computes it once per
// fragment (mapping/) and evaluates each of the noise's maps there (lichenValue).
#ifndef LICHEN_SHADING_POINT_GLSL
#define LICHEN_SHADING_POINT_GLSL

#include "method.glsl"
#include "solid_method.glsl"
#include "surface_method.glsl"
#include "triplanar.glsl"

/// What all maps of a noise share at one point; the parts of its method and mapping are set.
struct LichenShadingPoint {
  LichenMaterial material;
  LichenNoise noise;
  LichenPoint point;
  LichenSurfacePoint surface;
  LichenTriplanar triplanar;
  LichenSolidPoint solid;
};

/// The value of one map: light for colours, the decoded quantity for the others. For slopes, z is
/// the variance of a slope lost to filtering, for lichenRoughness; triplanar and solid ones are a
/// gradient in space, and the variance is w.
vec4 lichenValue(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table, LichenShadingPoint shading,
                 LichenMap map) {
#ifndef LICHEN_OMIT_TRIPLANAR
  if (lichenIsTriplanar(shading.material))
    return lichenTriplanarValue(image, table, shading.triplanar, shading.point, shading.noise, map);
#endif
#ifndef LICHEN_OMIT_SURFACE
  if (lichenIsSurface(shading.material, shading.noise))
    return lichenSurfaceValue(image, table, shading.surface, shading.point, shading.material,
                              shading.noise, map);
#endif
#ifndef LICHEN_OMIT_SOLID
  if (lichenIsSolid(shading.material, shading.noise))
    return lichenSolidValue(image, table, shading.solid, shading.material, shading.noise, map);
#endif
  return lichenValueAt(image, table, shading.point, shading.material, shading.noise, map);
}

#endif
