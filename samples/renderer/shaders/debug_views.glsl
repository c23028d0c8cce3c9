// SPDX-License-Identifier: MIT
// Debug views of the noise at a pixel as a colour; grey if the noise does not have the quantity.
#ifndef DEBUG_VIEWS_GLSL
#define DEBUG_VIEWS_GLSL

#include "scene_interface.h"
#include "surface.glsl"

layout(constant_id = 2) const int kDebugView = DEBUG_NONE;
// Chosen to be distinguishable.
const vec3 kNothingToShow = vec3(0.5);
const vec3 kLineColor = vec3(0.9, 0.35, 0.1);
const float kLineWeight = 0.03; // smallest weight that is not on a line of the lattice
const float kCellDarkest = 0.15;
const float kCellContrast = 0.5;
const float kMostImpacts = 60.0; // per pixel; twice the usual mean
const float kImpactsInSpace = 2.0; // times as many with surface and triplanar mapping

/// Blue, cyan, green, yellow, red for 0, 1/4, 1/2, 3/4, 1, linear between.
vec3 ramp(float x) {
  return clamp(vec3(4.0 * x - 2.0, min(4.0 * x, 4.0 - 4.0 * x), 2.0 - 4.0 * x), 0.0, 1.0);
}

/// The map whose values the views show.
LichenMap shownMap() { return noiseData.maps[material.noiseMaps[NOISE_BASE_COLOR]]; }

/// Shows a Gaussian value with this map's number of dimensions.
vec3 shownGaussian(vec3 gaussian) {
  uint dimensions = shownMap().dimensions;
  if (dimensions == 1u)
    return gaussian.xxx;
  return vec3(gaussian.xy, dimensions == 2u ? kNothingToShow.z : gaussian.z);
}

/// Views of a tiling noise that need only its lattice.
vec3 tilingPlaceDebug(LichenTilingTaps taps) {
  if (kDebugView == DEBUG_WEIGHTS)
    return taps.point.weights;
  if (kDebugView == DEBUG_LATTICE) {
    float least = min(taps.point.weights.x, min(taps.point.weights.y, taps.point.weights.z));
    float inside = smoothstep(0.0, kLineWeight, least);
    return mix(kLineColor, kCellDarkest + kCellContrast * taps.point.weights, inside);
  }
  if (kDebugView != DEBUG_MIP_LEVEL || !noiseHas(NOISE_BASE_COLOR))
    return kNothingToShow;
  LichenMap map = shownMap();
  return ramp(lichenTilingLevel(taps.point, map) / max(float(map.mipCount) - 1.0, 1.0));
}

vec3 tilingDebug(LichenTilingTaps taps) {
  if (kDebugView != DEBUG_GAUSSIAN || !noiseHas(NOISE_BASE_COLOR))
    return tilingPlaceDebug(taps);
  return shownGaussian(
      lichenTilingGaussian(baseColorImage, taps, noiseData.noise, shownMap()).rgb);
}

#ifndef LICHEN_OMIT_TEXTONS
/// Views of a texton noise that need only its impacts, except their number.
vec3 textonPlaceDebug(LichenImpacts impacts) {
  if (kDebugView != DEBUG_MIP_LEVEL)
    return kNothingToShow;
  return ramp(impacts.level / max(float(noiseData.texton.mipCount) - 1.0, 1.0));
}

vec3 textonDebug(LichenImpacts impacts) {
  if (kDebugView == DEBUG_IMPACTS)
    return ramp(float(lichenImpactCount(impacts, noiseData.noise, noiseData.texton)) /
                kMostImpacts);
  if (kDebugView != DEBUG_GAUSSIAN || !noiseHas(NOISE_BASE_COLOR))
    return textonPlaceDebug(impacts);
  LichenMap map = shownMap();
  LichenMap here = lichenMixedMap(baseColorTable, impacts, map, noiseData.texton);
  LichenKept kept = lichenTextonKept(baseColorTable, impacts, map, noiseData.texton);
  return shownGaussian(lichenTextonGaussian(baseColorImage, impacts, kept, noiseData.noise, here,
                                            noiseData.texton));
}
#endif

#ifndef LICHEN_OMIT_SURFACE_TEXTONS
vec3 surfaceDebug(LichenPlace place) {
  if (kDebugView == DEBUG_IMPACTS)
    return ramp(float(lichenSurfaceImpactCount(place.surface, noiseData.noise, noiseData.texton)) /
                (kImpactsInSpace * kMostImpacts));
  if (kDebugView != DEBUG_GAUSSIAN || !noiseHas(NOISE_BASE_COLOR))
    return textonPlaceDebug(place.impacts);
  LichenMap map = shownMap();
  LichenMap here = lichenMixedMap(baseColorTable, place.impacts, map, noiseData.texton);
  LichenKept kept = lichenTextonKept(baseColorTable, place.impacts, map, noiseData.texton);
  return shownGaussian(lichenSurfaceTextonGaussian(baseColorImage, place.impacts, place.surface,
                                                   kept, noiseData.noise, here, noiseData.texton));
}
#endif

#ifndef LICHEN_OMIT_TRIPLANAR
/// Views of the contributing planes, blended like their values.
vec3 planesDebug(LichenTriplanar triplanar) {
  vec3 shown = vec3(0.0);
  float impacts = 0.0;
  int rank = 0;
  while (rank < triplanar.count) {
    LichenPlanePlace plane = lichenPlanePlace(triplanar, rank);
    float share = plane.weight * plane.weight;
#ifndef LICHEN_OMIT_TEXTONS
    if (lichenIsTexton(noiseData.noise)) {
      shown += share * textonPlaceDebug(plane.impacts);
      if (kDebugView == DEBUG_IMPACTS)
        impacts += float(lichenImpactCount(plane.impacts,
                                           lichenNoiseOfPlane(plane.axis, noiseData.noise),
                                           noiseData.texton));
    } else
#endif
      shown += share * tilingPlaceDebug(plane.taps);
    ++rank;
  }
  bool counts = kDebugView == DEBUG_IMPACTS && noiseData.noise.method == uint(LICHEN_METHOD_TEXTON);
  return counts ? ramp(impacts / (kImpactsInSpace * kMostImpacts)) : shown;
}

vec3 triplanarDebug(LichenTriplanar triplanar, float mixWeight) {
  if (kDebugView == DEBUG_PLANES) {
    vec3 weights = lichenPlaneWeights(triplanar.normal, noiseData.noise);
    return weights * weights;
  }
  if (kDebugView != DEBUG_GAUSSIAN || !noiseHas(NOISE_BASE_COLOR))
    return planesDebug(triplanar);
  LichenMap map = shownMap();
  lichenSetTriplanarMix(triplanar, mixWeight);
  LichenMap here =
      lichenTriplanarMap(baseColorTable, triplanar, noiseData.noise, map, noiseData.texton);
  return shownGaussian(lichenTriplanarBlend(baseColorImage, baseColorTable, triplanar,
                                            noiseData.noise, map, here, noiseData.texton)
                           .gaussian);
}
#endif

vec3 noiseDebug(Footprint footprint) {
  if (!kHasNoise)
    return kNothingToShow;
  LichenPlace place = noisePlace(footprint);
#ifndef LICHEN_OMIT_TRIPLANAR
  if (lichenIsTriplanar(noiseData.noise))
    return triplanarDebug(place.triplanar, place.impacts.mixWeight);
#endif
#ifndef LICHEN_OMIT_SURFACE_TEXTONS
  if (lichenIsTexton(noiseData.noise) && lichenIsSurface(noiseData.texton))
    return surfaceDebug(place);
#endif
#ifndef LICHEN_OMIT_TEXTONS
  if (lichenIsTexton(noiseData.noise))
    return textonDebug(place.impacts);
#endif
  return tilingDebug(place.taps);
}

#endif
