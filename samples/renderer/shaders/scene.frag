#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// A surface's radiance toward the camera, or one quantity of it (debug views).
#include "scene_interface.h"
#include "surface.glsl"
#include "shading.glsl"

layout(constant_id = 2) const int kDebugView = DEBUG_NONE;
// Of the debug views, chosen to be told apart.
const vec3 kNothingToShow = vec3(0.5);
const vec3 kLineColor = vec3(0.9, 0.35, 0.1);
const float kLineWeight = 0.03; // the least weight that is no longer on a line of the lattice
const float kCellDarkest = 0.15;
const float kCellContrast = 0.5;
const float kMostImpacts = 60.0; // of a pixel, twice the usual mean
const float kSurfaceImpacts = 2.0; // times as many on a surface
const float kLeastNDotV = 1e-3; // keeps the visibility term finite

layout(location = 0) in vec3 worldPosition;
layout(location = 1) in vec3 worldNormal;
layout(location = 2) in vec4 worldTangent;
layout(location = 3) in vec4 texCoords;
layout(location = 4) in vec4 vertexColor;
layout(location = 5) in float mixWeight;
layout(location = 0) out vec4 color;

vec3 shadingNormal(vec3 n, Surface surface) {
  if (!kHasNormalMap && !kHasNoise)
    return n;
  if (kHasNoise && surface.gradient != vec3(0.0))
    return lichenNormalFromGradient(n, surface.gradient);
  vec3 tangentNormal = surface.tangentNormal;
  vec3 t = worldTangent.xyz - n * dot(n, worldTangent.xyz);
  float length2 = dot(t, t);
  if (length2 <= 0.0)
    return n;
  t *= inversesqrt(length2);
  vec3 b = cross(n, t) * worldTangent.w;
  if (!gl_FrontFacing)
    t = -t; // the whole frame turns with the normal; b has turned by the cross product
  return normalize(t * tangentNormal.x + b * tangentNormal.y + n * tangentNormal.z);
}

Shading prepare(Surface surface, vec3 geometricNormal) {
  Shading s;
  s.position = worldPosition;
  s.geometricNormal = geometricNormal;
  s.view = frame.cameraPosition.w != 0.0 ? normalize(frame.cameraPosition.xyz - worldPosition)
                                         : -frame.cameraForward.xyz;
  s.normal = shadingNormal(geometricNormal, surface);
  // A normal map may turn a surface away from the camera that sees it.
  s.nDotV = clamp(dot(s.normal, s.view), kLeastNDotV, 1.0);
  s.roughness = clamp(surface.roughness, 0.0, 1.0);
  s.alpha = alphaOf(s.roughness);
  float metallic = clamp(surface.metallic, 0.0, 1.0);
  s.diffuseColor = surface.baseColor.rgb * (1.0 - metallic);
  s.f0 = mix(vec3(kDielectricF0), surface.baseColor.rgb, metallic);
  s.brdf = textureLod(brdfTable, vec2(s.nDotV, s.roughness), 0.0).xyz;
  return s;
}

vec3 lit(Shading s, Surface surface) {
  vec3 light = surface.emissive;
  light += environmentLight(s, skyVisibility(s), surface.occlusion);
  for (int i = 0; i < frame.counts.x; ++i) {
    vec3 direct = punctualLight(s, frame.lights[i]);
    if (i == 0 && frame.environment.w != 0.0 && direct != vec3(0.0))
      direct *= sunVisibility(s);
    light += direct;
  }
  return light;
}

/// Blue, cyan, green, yellow, red for 0, 1/4, 1/2, 3/4, 1, linear between.
vec3 ramp(float x) {
  return clamp(vec3(4.0 * x - 2.0, min(4.0 * x, 4.0 - 4.0 * x), 2.0 - 4.0 * x), 0.0, 1.0);
}

/// A Gaussian value of a map's dimensions.
vec3 shownGaussian(vec3 gaussian, LichenMap map) {
  if (map.dimensions == 1u)
    return gaussian.xxx;
  return vec3(gaussian.xy, map.dimensions == 2u ? kNothingToShow.z : gaussian.z);
}

/// The views that texton noises have.
vec3 textonDebug(LichenImpacts impacts) {
  if (kDebugView == DEBUG_IMPACTS)
    return ramp(float(lichenImpactCount(impacts, noiseData.noise, noiseData.texton)) /
                kMostImpacts);
  if (kDebugView == DEBUG_MIP_LEVEL)
    return ramp(impacts.level / max(float(noiseData.texton.mipCount) - 1.0, 1.0));
  if (kDebugView != DEBUG_GAUSSIAN || !noiseHas(NOISE_BASE_COLOR))
    return kNothingToShow;
  LichenMap map = noiseData.maps[material.noiseMaps[NOISE_BASE_COLOR]];
  LichenMap here = lichenMixedMap(baseColorTable, impacts, map, noiseData.texton);
  LichenKept kept = lichenTextonKept(baseColorTable, impacts, map, noiseData.texton);
  return shownGaussian(lichenTextonGaussian(baseColorImage, impacts, kept, noiseData.noise, here,
                                            noiseData.texton),
                       map);
}

#ifndef LICHEN_OMIT_SURFACE_TEXTONS
/// Of those, what is otherwise on a surface.
vec3 surfaceDebug(LichenPlace place) {
  if (kDebugView == DEBUG_IMPACTS)
    return ramp(float(lichenSurfaceImpactCount(place.surface, noiseData.noise, noiseData.texton)) /
                (kSurfaceImpacts * kMostImpacts));
  if (kDebugView != DEBUG_GAUSSIAN || !noiseHas(NOISE_BASE_COLOR))
    return textonDebug(place.impacts);
  LichenMap map = noiseData.maps[material.noiseMaps[NOISE_BASE_COLOR]];
  LichenMap here = lichenMixedMap(baseColorTable, place.impacts, map, noiseData.texton);
  LichenKept kept = lichenTextonKept(baseColorTable, place.impacts, map, noiseData.texton);
  return shownGaussian(lichenSurfaceTextonGaussian(baseColorImage, place.impacts, place.surface,
                                                   kept, noiseData.noise, here, noiseData.texton),
                       map);
}
#endif

#ifndef LICHEN_OMIT_TRIPLANAR
/// The views that triplanar noises have.
vec3 triplanarDebug(LichenTriplanar triplanar, float mixWeight) {
  if (kDebugView == DEBUG_WEIGHTS) {
    vec3 weights = lichenPlaneWeights(triplanar.normal, noiseData.noise);
    return weights * weights;
  }
  if (kDebugView != DEBUG_GAUSSIAN || !noiseHas(NOISE_BASE_COLOR))
    return kNothingToShow;
  LichenMap map = noiseData.maps[material.noiseMaps[NOISE_BASE_COLOR]];
  lichenSetTriplanarMix(triplanar, mixWeight);
  LichenMap here =
      lichenTriplanarMap(baseColorTable, triplanar, noiseData.noise, map, noiseData.texton);
  vec3 lost;
  return shownGaussian(lichenTriplanarGaussian(baseColorImage, baseColorTable, triplanar,
                                               noiseData.noise, map, here, noiseData.texton, lost),
                       map);
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
  LichenTaps taps = place.taps;
  if (kDebugView == DEBUG_IMPACTS)
    return kNothingToShow;
  if (kDebugView == DEBUG_WEIGHTS)
    return taps.weights;
  if (kDebugView == DEBUG_LATTICE) {
    float least = min(taps.weights.x, min(taps.weights.y, taps.weights.z));
    float inside = smoothstep(0.0, kLineWeight, least);
    return mix(kLineColor, kCellDarkest + kCellContrast * taps.weights, inside);
  }
  // The others are of the base colour.
  if (!noiseHas(NOISE_BASE_COLOR))
    return kNothingToShow;
  LichenMap map = noiseData.maps[material.noiseMaps[NOISE_BASE_COLOR]];
  float level = lichenTilingLevel(taps, noiseData.noise, map);
  if (kDebugView == DEBUG_MIP_LEVEL)
    return ramp(level / max(float(map.mipCount) - 1.0, 1.0));
  return shownGaussian(lichenTilingGaussian(baseColorImage, taps, level), map);
}

void main() {
  float scale = frame.environment.z;
  Footprint footprint =
      Footprint(texCoords, dFdx(texCoords) * scale, dFdy(texCoords) * scale, worldPosition,
                dFdx(worldPosition) * scale, dFdy(worldPosition) * scale, worldNormal, worldTangent,
                mixWeight);
  vec3 normal = normalize(worldNormal) * (gl_FrontFacing ? 1.0 : -1.0);
  Surface surface = surfaceAt(footprint, vertexColor);
  if (material.flags.y == ALPHA_OPAQUE)
    surface.baseColor.a = 1.0;
  else if (surface.baseColor.a < material.emissive.w)
    discard;
  Shading s = prepare(surface, normal);
  vec3 shown = vec3(0.0);
  if (kDebugView == DEBUG_NONE)
    shown = throughHaze(s, lit(s, surface));
  else if (kDebugView == DEBUG_NORMALS)
    shown = 0.5 + 0.5 * s.normal;
  else if (kDebugView == DEBUG_BASE_COLOR)
    shown = surface.baseColor.rgb;
  else
    shown = noiseDebug(footprint);
  color = vec4(shown, surface.baseColor.a);
}
