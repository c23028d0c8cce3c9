// SPDX-License-Identifier: MIT
// The seam between methods and solids. Each method that has solids has for its own type of point:
//   lichenSetSolidPoint   what all maps share at a point
//   lichenSolidGaussianAt the Gaussian value of a map there, in w the share of its variance that
//                         filtering loses; of slopes also the one along z
#ifndef LICHEN_SOLID_METHOD_GLSL
#define LICHEN_SOLID_METHOD_GLSL

#include "../interface/fetch.glsl"
#include "../interface/lichen_interface.h"
#include "decode.glsl"
#include "method_choice.glsl"
#include "solid_cosines.glsl"
#include "solid_footprint.glsl"
#include "solid_kernels.glsl"
#include "tile_frame.glsl"

/// What all maps of a solid noise share at one point; the member of its method is set.
#define LICHEN_SOLID_MEMBER(name, Type, number) Type name;
struct LichenSolidPoint {
  LICHEN_EACH_SOLID_METHOD(LICHEN_SOLID_MEMBER)
#ifdef LICHEN_OMIT_SOLID
  float none;
#endif
};

/// The point at `position` [tiles, relative to the host's integer tile origin; along z as long as
/// wide] of a pixel with these gradients [tiles / pixel].
LichenSolidPoint lichenSolidPointAt(vec3 position, vec3 gradientX, vec3 gradientY,
                                    LichenMaterial material, LichenNoise noise) {
  LichenSolidPoint point;
  LichenSolidFootprint footprint = lichenSolidFootprint(gradientX, gradientY, noise);
#define LICHEN_SOLID_POINT_AT(name, Type, number)                                                  \
  if (lichenHasMethod(number, noise))                                                              \
    lichenSetSolidPoint(point.name, position, footprint, material);
  LICHEN_EACH_SOLID_METHOD(LICHEN_SOLID_POINT_AT)
  return point;
}

/// The Gaussian value of a map, and in w the share of its variance that filtering loses.
/// `depthSlope`: of slopes, that along z, stored.
vec4 lichenSolidGaussian(LICHEN_IMAGE_2D image, LichenSolidPoint point, LichenMaterial material,
                         LichenNoise noise, LichenMap map, LICHEN_OUT(float) depthSlope) {
  vec4 gaussian = vec4(0.5, 0.5, 0.5, 0.0);
  depthSlope = 0.0;
#define LICHEN_SOLID_GAUSSIAN(name, Type, number)                                                  \
  if (lichenHasMethod(number, noise))                                                              \
    gaussian = lichenSolidGaussianAt(image, point.name, material, noise, map, depthSlope);
  LICHEN_EACH_SOLID_METHOD(LICHEN_SOLID_GAUSSIAN)
  return gaussian;
}

/// The value of one map, as lichenTriplanarValue returns it.
vec4 lichenSolidValue(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table, LichenSolidPoint point,
                      LichenMaterial material, LichenNoise noise, LichenMap map) {
  float depthSlope;
  vec4 gaussian = lichenSolidGaussian(image, point, material, noise, map, depthSlope);
  vec4 value = lichenDecode(table, gaussian.rgb, gaussian.w, material.contrast, map);
  if (map.encoding != uint(LICHEN_ENCODING_SLOPE))
    return value;
  vec2 slopes = lichenSlopesToUv(value.xy, material); // to the right and up: along x and y
  return vec4(slopes, depthSlope, value.z);
}

#endif
