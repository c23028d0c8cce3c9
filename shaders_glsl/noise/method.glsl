// SPDX-License-Identifier: MIT
// The seam between methods and mappings: any noise at a point of a plane. Mappings call these
// functions and name no method. Each method has them too, for its own type of point:
//   lichenSetPoint   what all maps share at a point
//   lichenGaussianAt the Gaussian value of a map there, and what filtering lost of it
//   lichenDecodedAt  the value that a Gaussian value stands for
//   lichenValueAt    the value of a map there; of colours, both in one. Slopes of rotated tiles are
//                    decoded one by one, and only here
#ifndef LICHEN_METHOD_GLSL
#define LICHEN_METHOD_GLSL

#include "../interface/fetch.glsl"
#include "../interface/lichen_interface.h"
#include "local_random_phase.glsl"
#include "method_choice.glsl"
#include "multiple_kernels.glsl"
#ifdef LICHEN_HAS_QUILTING
#include "quilting.glsl"
#endif
#include "texton.glsl"
#include "tiling_options.glsl"

/// What all maps of a noise share at one point of a plane; the member of its method is set.
#define LICHEN_POINT_MEMBER(name, Type, number) Type name;
struct LichenPoint {
  LICHEN_EACH_METHOD(LICHEN_POINT_MEMBER)
};

/// The point at `position` [tiles, relative to the host's integer tile origin] of a pixel with
/// these gradients [tiles / pixel].
LichenPoint lichenPointAt(vec2 position, vec2 gradientX, vec2 gradientY, LichenMaterial material,
                          LichenNoise noise) {
  LichenPoint point;
#define LICHEN_POINT_AT(name, Type, number)                                                        \
  if (lichenHasMethod(number, noise))                                                              \
    lichenSetPoint(point.name, position, gradientX, gradientY, material, noise);
  LICHEN_EACH_METHOD(LICHEN_POINT_AT)
  return point;
}

/// The Gaussian value of a map: mean 1/2, deviation 1/6 where nothing is lost. `lost` is the share
/// of each channel's variance that filtering lost. `table` is that of the map's binding.
vec3 lichenGaussianAt(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table, LichenPoint point,
                      LichenMaterial material, LichenNoise noise, LichenMap map,
                      LICHEN_OUT(vec3) lost) {
  vec3 gaussian = vec3(0.5);
  lost = vec3(0.0);
#define LICHEN_GAUSSIAN_AT(name, Type, number)                                                     \
  if (lichenHasMethod(number, noise))                                                              \
    gaussian = lichenGaussianAt(image, table, point.name, material, noise, map, lost);
  LICHEN_EACH_METHOD(LICHEN_GAUSSIAN_AT)
  return gaussian;
}

/// The value that a Gaussian value stands for: light for colours, the decoded quantity for others.
vec4 lichenDecodedAt(LICHEN_IMAGE_3D table, vec3 gaussian, vec3 lost, LichenPoint point,
                     LichenMaterial material, LichenNoise noise, LichenMap map) {
  vec4 value = vec4(0.0);
#define LICHEN_DECODED_AT(name, Type, number)                                                      \
  if (lichenHasMethod(number, noise))                                                              \
    value = lichenDecodedAt(table, gaussian, lost, point.name, material, noise, map);
  LICHEN_EACH_METHOD(LICHEN_DECODED_AT)
  return value;
}

/// The value of a map. For slopes, z is the variance of a slope lost to filtering.
vec4 lichenValueAt(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table, LichenPoint point,
                   LichenMaterial material, LichenNoise noise, LichenMap map) {
  vec4 value = vec4(0.0);
#define LICHEN_VALUE_AT(name, Type, number)                                                        \
  if (lichenHasMethod(number, noise))                                                              \
    value = lichenValueAt(image, table, point.name, material, noise, map);
  LICHEN_EACH_METHOD(LICHEN_VALUE_AT)
  return value;
}

#endif
