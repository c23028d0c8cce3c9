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

bool hasMethod(int method) { return lichenHasMethod(method, lichenNoise); }

/// A mip level of the map that the views show.
vec3 shownLevel(float level, float mipCount) { return ramp(level / max(mipCount - 1.0, 1.0)); }

/// Views of tiling that need only its lattice.
#if (LICHEN_METHODS & 1) != 0
vec3 tilingDebug(LichenTilingPoint point) {
  if (kDebugView == DEBUG_WEIGHTS)
    return point.weights;
  if (kDebugView == DEBUG_LATTICE) {
    float least = min(point.weights.x, min(point.weights.y, point.weights.z));
    float inside = smoothstep(0.0, kLineWeight, least);
    return mix(kLineColor, kCellDarkest + kCellContrast * point.weights, inside);
  }
  if (kDebugView != DEBUG_MIP_LEVEL || !LICHEN_HAS(LICHEN_BASE_COLOR))
    return kNothingToShow;
  LichenMap map = shownMap();
  return shownLevel(lichenTilingLevel(point, lichenMaterial, lichenNoise, map),
                    float(map.mipCount));
}
#endif

#if (LICHEN_METHODS & 16) != 0
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
  return shownLevel(lichenSharpLevel(point.footprintLevel + map.levelOffset), float(map.mipCount));
}
#endif

/// Views of a point of a plane or a surface, but for the number of impacts.
vec3 pointDebug(LichenPoint point) {
#if (LICHEN_METHODS & 1) != 0
  if (hasMethod(LICHEN_METHOD_TILING))
    return tilingDebug(point.tiling);
#endif
#if (LICHEN_METHODS & 2) != 0
  if (hasMethod(LICHEN_METHOD_TEXTON) && kDebugView == DEBUG_MIP_LEVEL)
    return shownLevel(point.texton.level, float(lichenTextonNoise(lichenNoise).mipCount));
#endif
#if (LICHEN_METHODS & 16) != 0
  if (hasMethod(LICHEN_METHOD_QUILTING))
    return quiltingDebug(point.quilting);
#endif
  return kNothingToShow;
}

/// The impacts that reach a point.
float impactsAt(LichenPoint point) {
  float count = 0.0;
#if (LICHEN_METHODS & 2) != 0
  LichenImpacts impacts = point.texton;
#if LICHEN_HAS_SURFACES
  if (lichenIsSurface(lichenMaterial)) {
    LichenSurfaceWalk walk = lichenFirstSurfaceImpact(impacts.cubes);
    while (lichenHasImpact(walk, impacts.cubes)) {
      lichenSurfaceStep(walk, impacts.cubes);
      count += walk.isReached ? 1.0 : 0.0;
    }
    return count;
  }
#endif
  LichenWalk walk = lichenFirstImpact(impacts, lichenMaterial);
  while (lichenHasImpact(walk, impacts)) {
    lichenStep(walk, impacts, lichenMaterial, lichenNoise);
    count += walk.isReached ? 1.0 : 0.0;
  }
#endif
  return count;
}

vec3 noiseDebug(Footprint footprint) {
  LichenShadingPoint shading = noisePoint(footprint);
  if (kDebugView == DEBUG_GAUSSIAN) // quilting has no such value
    return LICHEN_HAS(LICHEN_BASE_COLOR) && !hasMethod(LICHEN_METHOD_QUILTING)
               ? shownGaussian(lichenGaussian(LICHEN_IMAGE(LICHEN_BASE_COLOR),
                                              LICHEN_TABLE(LICHEN_BASE_COLOR), shading, shownMap())
                                   .value)
               : kNothingToShow;
  bool counts = kDebugView == DEBUG_IMPACTS && hasMethod(LICHEN_METHOD_TEXTON);
#if LICHEN_HAS_TRIPLANAR
  if (lichenIsTriplanar(lichenMaterial)) {
    if (kDebugView == DEBUG_PLANES)
      return shading.triplanar.weights * shading.triplanar.weights;
    // The contributing planes, blended like their values.
    vec3 shown = vec3(0.0);
    float impacts = 0.0;
    int rank = 0;
    while (rank < shading.triplanar.count) {
      LichenPlanePoint plane =
          lichenPlanePoint(shading.triplanar, rank, shading.point, lichenNoise);
      if (counts)
        impacts += impactsAt(plane.point);
      shown += plane.weight * plane.weight * pointDebug(plane.point);
      ++rank;
    }
    return counts ? ramp(impacts / (kImpactsInSpace * kMostImpacts)) : shown;
  }
#endif
  if (counts) {
    float most = kMostImpacts * (lichenIsSurface(lichenMaterial) ? kImpactsInSpace : 1.0);
    return ramp(impactsAt(shading.point) / most);
  }
  return pointDebug(shading.point);
}
#endif

#endif
