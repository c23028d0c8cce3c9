// SPDX-License-Identifier: MIT
// The seam between methods and mappings: a point (what all maps share there), the Gaussian value of
// a map with the share of its variance that filtering lost, and what they stand for. Mappings call
// these and name no method.
#ifndef LICHEN_METHOD_GLSL
#define LICHEN_METHOD_GLSL

#include "../interface/fetch.glsl"
#include "../interface/lichen_interface.h"
#include "method_choice.glsl"
#include "texton.glsl"
#include "texton_mix.glsl"
#include "tiling_options.glsl"

/// What all maps of a noise share at one point of a plane; the part of its method is set.
struct LichenPoint {
  LichenTilingTaps taps;
  LichenImpacts impacts;
};

/// The point at `position` [tiles, relative to the host's integer tile origin] of a pixel with
/// these gradients [tiles / pixel].
LichenPoint lichenPointAt(vec2 position, vec2 gradientX, vec2 gradientY, LichenMaterial material,
                          LichenNoise noise) {
  LichenPoint point;
#ifndef LICHEN_OMIT_TEXTONS
  if (lichenIsTexton(noise))
    point.impacts = lichenImpactsAt(position, gradientX, gradientY, material, noise);
  else
#endif
    point.taps = lichenTilingTaps(position, gradientX, gradientY, material, noise);
  return point;
}

/// What a point takes from its texture coordinates: the weight of a mix.
void lichenTakeUv(inout LichenPoint point, vec2 uv, LichenMaterial material, LichenNoise noise) {
#ifndef LICHEN_OMIT_TEXTONS
  if (lichenIsTexton(noise) && lichenIsMix(noise))
    lichenMixByUv(point.impacts, uv, material);
#endif
}

/// A point of a mapping without texture coordinates: the weight of a mix where it is a constant. Of a
/// direction, which texture coordinates have, a host sets it:
/// lichenSetMix(place.point.impacts, lichenMixWeight(uv, material), vec2(0.0)).
void lichenTakeMaterial(inout LichenPoint point, LichenMaterial material, LichenNoise noise) {
#ifndef LICHEN_OMIT_TEXTONS
  if (lichenIsTexton(noise))
    point.impacts.mixWeight = lichenTextonMaterial(material).mixWeight;
#endif
}

/// What a point takes from another: the weight of a mix.
void lichenTakeMix(inout LichenPoint point, LichenPoint other) {
#ifndef LICHEN_OMIT_TEXTONS
  point.impacts.mixWeight = other.impacts.mixWeight;
#endif
}

/// What was fetched of one map at a point. Compilers do not fetch once what is written twice, where
/// images and samplers are separate.
struct LichenFetched {
  vec3 gaussian;     // mean 1/2, deviation 1/6 where nothing is lost
  vec3 lost;         // the share of each channel's variance that filtering lost
  LichenTiles tiles; // of tiling
};

/// `table` is that of the map's binding.
LichenFetched lichenFetch(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table, LichenPoint point,
                          LichenMaterial material, LichenNoise noise, LichenMap map) {
  LichenFetched fetched;
#ifndef LICHEN_OMIT_TEXTONS
  if (lichenIsTexton(noise)) {
    fetched.gaussian =
        lichenTextonValue(image, table, point.impacts, material, noise, map, fetched.lost);
    return fetched;
  }
#endif
  fetched.tiles = lichenTilingTiles(image, point.taps, map);
  vec4 blend = lichenTilesBlend(fetched.tiles, point.taps);
  fetched.gaussian = blend.rgb;
  fetched.lost = vec3(fetched.tiles.lossShare * blend.a);
  return fetched;
}

/// The value that a Gaussian value stands for.
vec4 lichenDecodeAt(LICHEN_IMAGE_3D table, vec3 gaussian, vec3 lost, LichenPoint point,
                    LichenMaterial material, LichenNoise noise, LichenMap map) {
#ifndef LICHEN_OMIT_TEXTONS
  if (lichenIsTexton(noise)) // contrast scales what is missing with what is there
    return lichenDecodeGaussian(gaussian, material.contrast * material.contrast * lost,
                                lichenMixedMap(table, point.impacts, noise, map));
#endif
  return lichenDecode(table, gaussian, lost.x, material.contrast, map);
}

/// The value of one map of what was fetched: light for colours, the decoded quantity for the
/// others. Of slopes, z is the variance of a slope that the footprint hides.
vec4 lichenFetchedValue(LICHEN_IMAGE_3D table, LichenFetched fetched, LichenPoint point,
                        LichenMaterial material, LichenNoise noise, LichenMap map) {
#ifndef LICHEN_OMIT_TEXTONS
  if (lichenIsTexton(noise))
    return lichenDecodeAt(table, fetched.gaussian, fetched.lost, point, material, noise, map);
#endif
  return lichenTilesValue(table, fetched.tiles, point.taps, map);
}

/// The same, fetched here.
vec4 lichenPointValue(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table, LichenPoint point,
                      LichenMaterial material, LichenNoise noise, LichenMap map) {
#ifndef LICHEN_OMIT_TEXTONS
  if (lichenIsTexton(noise))
    return lichenTexton(image, table, point.impacts, material, noise, map);
#endif
  return lichenTiling(image, table, point.taps, map);
}

#endif
