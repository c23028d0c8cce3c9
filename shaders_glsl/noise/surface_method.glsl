// SPDX-License-Identifier: MIT
// The seam between methods and surfaces. Each method that has surfaces has for its own type of
// point:
//   lichenSetSurfacePoint   what all maps share at a point, beside its point in a plane
//   lichenSurfaceGaussianAt the Gaussian value of a map there, and what filtering lost of it
//   lichenSurfaceValueAt    the value of a map there
#ifndef LICHEN_SURFACE_METHOD_GLSL
#define LICHEN_SURFACE_METHOD_GLSL

#include "../interface/fetch.glsl"
#include "../interface/lichen_interface.h"
#include "method.glsl"
#include "method_choice.glsl"
#include "surface_kernels.glsl"
#include "surface_texton.glsl"

/// What all maps of a noise share at one point of a surface; the member of its method is set.
#define LICHEN_SURFACE_MEMBER(name, Type, number) Type name;
struct LichenSurfacePoint {
  LICHEN_EACH_SURFACE_METHOD(LICHEN_SURFACE_MEMBER)
#ifdef LICHEN_OMIT_SURFACE
  float none;
#endif
};

/// The point at `position` [tile widths, relative to the host's integer tile origin]. The columns
/// of `frame` point to the right, down and outward in the exemplar: orthonormal. `point` has the
/// pixel's gradients in the tangent plane.
LichenSurfacePoint lichenSurfacePointAt(vec3 position, mat3 frame, LichenPoint point,
                                        LichenMaterial material, LichenNoise noise) {
  LichenSurfacePoint surface;
#define LICHEN_SURFACE_POINT_AT(name, Type, number)                                                \
  if (lichenHasMethod(number, noise))                                                              \
    lichenSetSurfacePoint(surface.name, position, frame, point.name, material, noise);
  LICHEN_EACH_SURFACE_METHOD(LICHEN_SURFACE_POINT_AT)
  return surface;
}

/// The Gaussian value of a map, as lichenGaussianAt returns it.
vec3 lichenSurfaceGaussian(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table, LichenSurfacePoint surface,
                           LichenPoint point, LichenMaterial material, LichenNoise noise,
                           LichenMap map, LICHEN_OUT(vec3) lost) {
  vec3 gaussian = vec3(0.5);
  lost = vec3(0.0);
#define LICHEN_SURFACE_GAUSSIAN_AT(name, Type, number)                                             \
  if (lichenHasMethod(number, noise))                                                              \
    gaussian = lichenSurfaceGaussianAt(image, table, surface.name, point.name, material, noise,    \
                                       map, lost);
  LICHEN_EACH_SURFACE_METHOD(LICHEN_SURFACE_GAUSSIAN_AT)
  return gaussian;
}

/// The value of a map, as lichenValueAt returns it.
vec4 lichenSurfaceValue(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table, LichenSurfacePoint surface,
                        LichenPoint point, LichenMaterial material, LichenNoise noise,
                        LichenMap map) {
  vec4 value = vec4(0.0);
#define LICHEN_SURFACE_VALUE_AT(name, Type, number)                                                \
  if (lichenHasMethod(number, noise))                                                              \
    value = lichenSurfaceValueAt(image, table, surface.name, point.name, material, noise, map);
  LICHEN_EACH_SURFACE_METHOD(LICHEN_SURFACE_VALUE_AT)
  return value;
}

#endif
