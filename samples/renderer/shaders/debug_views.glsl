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
const float kCutWeight = 0.5; // greatest weight in the middle of a cut
const float kLeastSum = 1e-6; // of weights: contrast may be 0
const float kCellDarkest = 0.15;
const float kCellContrast = 0.5;
const float kMostImpacts = 60.0; // per pixel; twice the usual mean
const float kImpactsInSpace = 2.0; // times as many with surface and triplanar mapping

#ifdef WITHOUT_NOISE
vec3 noiseDebug(Footprint footprint) { return kNothingToShow; }
#elif LICHEN_LAYERS > 1
/// A second evaluation would double the code, which drivers inline.
vec3 noiseDebug(Footprint footprint) { return kNothingToShow; }
#else
/// Blue, cyan, green, yellow, red for 0, 1/4, 1/2, 3/4, 1, linear between.
vec3 ramp(float x) {
  return clamp(vec3(4.0 * x - 2.0, min(4.0 * x, 4.0 - 4.0 * x), 2.0 - 4.0 * x), 0.0, 1.0);
}

/// The map whose values the views show.
LichenMap shownMap() { return lichenMaps[LICHEN_BASE_COLOR]; }

/// Shows a Gaussian value with this map's number of dimensions.
vec3 shownGaussian(vec3 gaussian) {
  uint dimensions = shownMap().dimensions;
  if (dimensions == 1u)
    return gaussian.xxx;
  return vec3(gaussian.xy, dimensions == 2u ? kNothingToShow.z : gaussian.z);
}

/// Views of a tiling noise that need only its lattice.
vec3 tilingPointDebug(LichenTilingTaps taps) {
  if (kDebugView == DEBUG_WEIGHTS)
    return taps.point.weights;
  if (kDebugView == DEBUG_LATTICE) {
    float least = min(taps.point.weights.x, min(taps.point.weights.y, taps.point.weights.z));
    float inside = smoothstep(0.0, kLineWeight, least);
    return mix(kLineColor, kCellDarkest + kCellContrast * taps.point.weights, inside);
  }
  if (kDebugView != DEBUG_MIP_LEVEL || !LICHEN_HAS(LICHEN_BASE_COLOR))
    return kNothingToShow;
  LichenMap map = shownMap();
  return ramp(lichenTilingLevel(taps.point, map) / max(float(map.mipCount) - 1.0, 1.0));
}

vec3 tilingDebug(LichenTilingTaps taps) {
  if (kDebugView != DEBUG_GAUSSIAN || !LICHEN_HAS(LICHEN_BASE_COLOR))
    return tilingPointDebug(taps);
  return shownGaussian(
      lichenTilingGaussian(LICHEN_IMAGE(LICHEN_BASE_COLOR), taps, shownMap()).rgb);
}

#ifdef LICHEN_HAS_TEXTONS
/// Views of a texton noise that need only its impacts, except their number.
vec3 textonPointDebug(LichenImpacts impacts) {
  if (kDebugView != DEBUG_MIP_LEVEL)
    return kNothingToShow;
  return ramp(impacts.level / max(float(lichenTextonNoise(lichenNoise).mipCount) - 1.0, 1.0));
}

vec3 textonDebug(LichenImpacts impacts) {
  if (kDebugView == DEBUG_IMPACTS)
    return ramp(float(lichenImpactCount(impacts, lichenMaterial, lichenNoise)) / kMostImpacts);
  if (kDebugView != DEBUG_GAUSSIAN || !LICHEN_HAS(LICHEN_BASE_COLOR))
    return textonPointDebug(impacts);
  vec3 lost;
  return shownGaussian(lichenGaussianAt(LICHEN_IMAGE(LICHEN_BASE_COLOR),
                                         LICHEN_TABLE(LICHEN_BASE_COLOR), impacts, lichenMaterial,
                                         lichenNoise, shownMap(), lost));
}
#endif

#ifdef LICHEN_HAS_LOCAL_RANDOM_PHASE
vec3 localRandomPhaseDebug(LichenCosinesPoint point) {
  if (kDebugView != DEBUG_GAUSSIAN || !LICHEN_HAS(LICHEN_BASE_COLOR))
    return kNothingToShow;
  return shownGaussian(lichenCosinesGaussian(LICHEN_IMAGE(LICHEN_BASE_COLOR), point,
                                             lichenMaterial, lichenNoise, shownMap())
                           .rgb);
}
#endif

#ifdef LICHEN_HAS_MULTIPLE_KERNELS
vec3 multipleKernelsDebug(LichenKernelsPoint point) {
  if (kDebugView != DEBUG_GAUSSIAN || !LICHEN_HAS(LICHEN_BASE_COLOR))
    return kNothingToShow;
  return shownGaussian(
      lichenKernelsGaussian(LICHEN_IMAGE(LICHEN_BASE_COLOR), point, lichenMaterial, lichenNoise)
          .rgb);
}
#endif

#ifdef LICHEN_HAS_QUILTING
/// Tiles have the colours of their vertices, so that a tile has one colour everywhere.
vec3 quiltingDebug(LichenQuiltingPoint point) {
  vec2 shares = point.weights / max(point.weights.x + point.weights.y, kLeastSum);
  vec3 tiles = shares.x * vec3(equal(point.colors.xxx, uvec3(0u, 1u, 2u))) +
               shares.y * vec3(equal(point.colors.yyy, uvec3(0u, 1u, 2u)));
  if (kDebugView == DEBUG_WEIGHTS)
    return tiles;
  if (kDebugView == DEBUG_LATTICE) {
    float greatest = max(tiles.x, max(tiles.y, tiles.z));
    return mix(kLineColor, kCellDarkest + kCellContrast * tiles,
               smoothstep(kCutWeight, 1.0, greatest));
  }
  if (kDebugView != DEBUG_MIP_LEVEL || !LICHEN_HAS(LICHEN_BASE_COLOR))
    return kNothingToShow;
  LichenMap map = shownMap();
  return ramp(lichenSharpLevel(point.footprintLevel + map.levelOffset) /
              max(float(map.mipCount) - 1.0, 1.0));
}
#endif

#ifndef LICHEN_OMIT_SOLID
vec3 solidDebug(LichenSolidPoint point) {
  if (kDebugView != DEBUG_GAUSSIAN || !LICHEN_HAS(LICHEN_BASE_COLOR))
    return kNothingToShow;
  float depthSlope;
  return shownGaussian(lichenSolidGaussian(LICHEN_IMAGE(LICHEN_BASE_COLOR), point, lichenMaterial,
                                           lichenNoise, shownMap(), depthSlope)
                           .rgb);
}
#endif

#ifndef LICHEN_OMIT_SURFACE
vec3 surfaceDebug(LichenShadingPoint shading) {
#ifdef LICHEN_HAS_TEXTONS
  bool isTexton = lichenHasMethod(LICHEN_METHOD_TEXTON, lichenNoise);
  if (kDebugView == DEBUG_IMPACTS && isTexton)
    return ramp(float(lichenSurfaceImpactCount(shading.surface.texton)) /
                (kImpactsInSpace * kMostImpacts));
  if (kDebugView == DEBUG_MIP_LEVEL && isTexton)
    return textonPointDebug(shading.point.texton);
#endif
  if (kDebugView != DEBUG_GAUSSIAN || !LICHEN_HAS(LICHEN_BASE_COLOR))
    return kNothingToShow;
  vec3 lost;
  return shownGaussian(lichenSurfaceGaussian(
      LICHEN_IMAGE(LICHEN_BASE_COLOR), LICHEN_TABLE(LICHEN_BASE_COLOR), shading.surface,
      shading.point, lichenMaterial, lichenNoise, shownMap(), lost));
}
#endif

#ifndef LICHEN_OMIT_TRIPLANAR
/// Views of the contributing planes, blended like their values.
vec3 planesDebug(LichenShadingPoint shading) {
  vec3 shown = vec3(0.0);
  float impacts = 0.0;
  int rank = 0;
  while (rank < shading.triplanar.count) {
    LichenPlanePoint plane = lichenPlanePoint(shading.triplanar, rank, shading.point, lichenNoise);
    float share = plane.weight * plane.weight;
#ifdef LICHEN_HAS_TEXTONS
    if (lichenHasMethod(LICHEN_METHOD_TEXTON, lichenNoise)) {
      shown += share * textonPointDebug(plane.point.texton);
      if (kDebugView == DEBUG_IMPACTS)
        impacts += float(lichenImpactCount(plane.point.texton, lichenMaterial, lichenNoise));
    } else
#endif
#ifdef LICHEN_HAS_QUILTING
      if (lichenHasMethod(LICHEN_METHOD_QUILTING, lichenNoise))
        shown += share * quiltingDebug(plane.point.quilting);
      else
#endif
      if (lichenHasMethod(LICHEN_METHOD_TILING, lichenNoise))
        shown += share * tilingPointDebug(plane.point.tiling);
      else
        shown += share * kNothingToShow;
    ++rank;
  }
  bool counts = kDebugView == DEBUG_IMPACTS && lichenNoise.method == uint(LICHEN_METHOD_TEXTON);
  return counts ? ramp(impacts / (kImpactsInSpace * kMostImpacts)) : shown;
}

vec3 triplanarDebug(LichenShadingPoint shading) {
  if (kDebugView == DEBUG_PLANES)
    return shading.triplanar.weights * shading.triplanar.weights;
  if (kDebugView != DEBUG_GAUSSIAN || !LICHEN_HAS(LICHEN_BASE_COLOR))
    return planesDebug(shading);
  vec3 lost;
  return shownGaussian(lichenTriplanarGaussian(LICHEN_IMAGE(LICHEN_BASE_COLOR),
                                               LICHEN_TABLE(LICHEN_BASE_COLOR), shading.triplanar,
                                               shading.point, lichenNoise, shownMap(), lost));
}
#endif

vec3 noiseDebug(Footprint footprint) {
  LichenShadingPoint shading = noisePoint(footprint);
#ifndef LICHEN_OMIT_TRIPLANAR
  if (lichenIsTriplanar(lichenMaterial))
    return triplanarDebug(shading);
#endif
#ifndef LICHEN_OMIT_SURFACE
  if (lichenIsSurface(lichenMaterial, lichenNoise))
    return surfaceDebug(shading);
#endif
#ifdef LICHEN_HAS_TEXTONS
  if (lichenHasMethod(LICHEN_METHOD_TEXTON, lichenNoise))
    return textonDebug(shading.point.texton);
#endif
#ifndef LICHEN_OMIT_SOLID
  if (lichenIsSolid(lichenMaterial, lichenNoise))
    return solidDebug(shading.solid);
#endif
#ifdef LICHEN_HAS_LOCAL_RANDOM_PHASE
  if (lichenHasMethod(LICHEN_METHOD_LOCAL_RANDOM_PHASE, lichenNoise))
    return localRandomPhaseDebug(shading.point.localRandomPhase);
#endif
#ifdef LICHEN_HAS_MULTIPLE_KERNELS
  if (lichenHasMethod(LICHEN_METHOD_MULTIPLE_KERNELS, lichenNoise))
    return multipleKernelsDebug(shading.point.multipleKernels);
#endif
#ifdef LICHEN_HAS_QUILTING
  if (lichenHasMethod(LICHEN_METHOD_QUILTING, lichenNoise))
    return quiltingDebug(shading.point.quilting);
#endif
  return tilingDebug(shading.point.tiling);
}
#endif

#endif
