// SPDX-License-Identifier: MIT
// glTF's metallic-roughness model under punctual lights and an environment.
// [glTF 2.0, appendix B]; energy of multiple scattering, of lights [Kulla and Conty 2017, Revisiting
// Physically Based Shading at Imageworks] and of the environment [Fdez-Aguera 2019, A
// Multiple-Scattering Microfacet Model for Real-Time Image-based Lighting]; GGX [Walter et al.
// 2007, eq. 33]; Smith's visibility [Heitz 2014, eq. 99]; Fresnel [Schlick 1994].
#ifndef SHADING_GLSL
#define SHADING_GLSL

#include "panorama.glsl"
#include "scene_interface.h"

layout(std140, set = SET_FRAME, binding = BINDING_FRAME) uniform FrameBlock { FrameData frame; };
layout(set = SET_FRAME, binding = BINDING_SPECULAR) uniform samplerCube specularCube;
layout(set = SET_FRAME, binding = BINDING_DIFFUSE) uniform samplerCube diffuseCube;
layout(set = SET_FRAME, binding = BINDING_BRDF) uniform sampler2D brdfTable;
layout(set = SET_FRAME, binding = BINDING_PANORAMA) uniform sampler2D panorama;
layout(set = SET_FRAME, binding = BINDING_SUN_DEPTH) uniform sampler2DShadow sunDepth;
layout(set = SET_FRAME, binding = BINDING_SKY_DEPTH) uniform sampler2DArrayShadow skyDepth;

const float kPi = 3.14159265358979;
const float kDielectricF0 = 0.04; // [glTF 2.0, appendix B]: an index of refraction of 1.5
const float kSchlickPower = 5.0;
const float kLeastAlpha = 0.002; // environment.cpp's alphaOf

struct Shading {
  vec3 position;
  vec3 geometricNormal;
  vec3 normal;
  vec3 view; // toward the camera
  float nDotV;
  vec3 diffuseColor;
  vec3 f0;
  float roughness;
  float alpha;
  vec4 brdf; // scale and bias of f0 under a uniform environment; loss; its mean
};

float alphaOf(float roughness) { return max(roughness * roughness, kLeastAlpha); }

const float kMeanSchlick = 1.0 / 21.0; // cosine-weighted mean of Schlick's power

vec3 meanFresnel(vec3 f0) { return f0 + (1.0 - f0) * kMeanSchlick; }

/// [Kulla and Conty 2017, "Multiple scattering"]: the lobe of what single scattering loses. The same
/// when light and view change places, which a factor to single scattering would not be.
vec3 scatteredAgain(Shading s, float nDotL) {
  const float kLeastLost = 1e-5; // of a mirror
  float lostOfLight = textureLod(brdfTable, vec2(nDotL, s.roughness), 0.0).z;
  float lostOfView = s.brdf.z;
  float lost = max(s.brdf.w, kLeastLost);
  vec3 average = meanFresnel(s.f0);
  vec3 color = average * average * (1.0 - lost) / (1.0 - average * lost);
  return color * (lostOfLight * lostOfView / (kPi * lost));
}

/// Light reflected of a light from direction l with irradiance 1 on a surface that faces it.
vec3 reflected(Shading s, vec3 l) {
  float nDotL = dot(s.normal, l);
  if (nDotL <= 0.0)
    return vec3(0.0);
  vec3 h = normalize(l + s.view);
  float nDotH = clamp(dot(s.normal, h), 0.0, 1.0);
  float vDotH = clamp(dot(s.view, h), 0.0, 1.0);
  float a2 = s.alpha * s.alpha;
  float d = nDotH * nDotH * (a2 - 1.0) + 1.0;
  float distribution = a2 / (kPi * d * d);
  float visibility = 0.5 / (nDotL * sqrt(s.nDotV * s.nDotV * (1.0 - a2) + a2) +
                            s.nDotV * sqrt(nDotL * nDotL * (1.0 - a2) + a2));
  vec3 fresnel = s.f0 + (1.0 - s.f0) * pow(1.0 - vDotH, kSchlickPower);
  vec3 specular = fresnel * (distribution * visibility) + scatteredAgain(s, nDotL);
  return nDotL * ((1.0 - fresnel) * s.diffuseColor / kPi + specular);
}

// Shadow edges: four taps this far from the place, each a tent of one texel's radius (bilinear
// comparison). Along an axis two tents a texel apart add up to a trapezoid, flat in its middle.
const float kShadowTapTexels = 0.5;
// So the filter reaches r texels along an axis. Lifted by r along its normal, a plane at angle a to
// the light does not shadow itself: that gains r / cos a toward the light, and the plane rises by
// r tan a at most. (Across the axes the reach is longer; the depth maps' slope bias is for that.)
const float kShadowReachTexels = kShadowTapTexels + 1.0;

/// Four taps of hardware comparison around a place of a depth map. Here and below the level is
/// explicit: neighbouring pixels may not come here, so there are no derivatives to choose it by.
float sunVisibility(Shading s) {
  vec3 lifted = s.position + s.geometricNormal * (kShadowReachTexels * frame.shadow.x);
  vec3 place = (frame.sunFromWorld * vec4(lifted, 1.0)).xyz;
  if (any(lessThan(place.xy, vec2(0.0))) || any(greaterThan(place.xy, vec2(1.0))))
    return 1.0;
  vec2 texel = kShadowTapTexels / vec2(textureSize(sunDepth, 0));
  float depth = min(place.z, 1.0);
  return 0.25 * (textureLod(sunDepth, vec3(place.xy + vec2(-texel.x, -texel.y), depth), 0.0) +
                 textureLod(sunDepth, vec3(place.xy + vec2(texel.x, -texel.y), depth), 0.0) +
                 textureLod(sunDepth, vec3(place.xy + vec2(-texel.x, texel.y), depth), 0.0) +
                 textureLod(sunDepth, vec3(place.xy + texel, depth), 0.0));
}

/// The share of the upper sky, as it lights the normal, that nothing hides. One frame looks in a
/// few directions; the average of frames looks everywhere.
float skyVisibility(Shading s) {
  const float kLeast = 0.02; // a normal that faces none of the directions sees no sky to be hidden
  vec3 lifted = s.position + s.geometricNormal * (kShadowReachTexels * frame.shadow.y);
  float seen = kLeast;
  float all = kLeast;
  for (int k = 0; k < frame.counts.y; ++k) {
    float weight = max(dot(s.normal, frame.skyDirection[k].xyz), 0.0);
    vec3 place = (frame.skyFromWorld[k] * vec4(lifted, 1.0)).xyz;
    bool outside = any(lessThan(place.xy, vec2(0.0))) || any(greaterThan(place.xy, vec2(1.0)));
    // textureLod takes no array of shadow maps in this GLSL; gradients of zero mean level 0 too.
    float open = 1.0;
    if (!outside)
      open = textureGrad(skyDepth, vec4(place.xy, float(k), min(place.z, 1.0)), vec2(0.0),
                         vec2(0.0));
    seen += weight * open;
    all += weight;
  }
  return seen / all;
}

vec3 punctualLight(Shading s, LightData light) {
  int kind = int(light.positionAndKind.w);
  if (kind == LIGHT_DIRECTIONAL)
    return light.color.rgb * reflected(s, -light.directionAndRange.xyz);
  vec3 toLight = light.positionAndKind.xyz - s.position;
  const float kLeastSquared = 1e-8; // a point at the light itself
  float squared = max(dot(toLight, toLight), kLeastSquared);
  vec3 l = toLight * inversesqrt(squared);
  float attenuation = 1.0 / squared;
  if (light.directionAndRange.w > 0.0) {
    // KHR_lights_punctual's window.
    float ratio = squared / (light.directionAndRange.w * light.directionAndRange.w);
    attenuation *= clamp(1.0 - ratio * ratio, 0.0, 1.0);
  }
  if (kind == LIGHT_SPOT) {
    float cosine = dot(-l, light.directionAndRange.xyz);
    float cone = clamp((cosine - light.cone.x) * light.cone.y, 0.0, 1.0);
    attenuation *= cone * cone;
  }
  return attenuation * light.color.rgb * reflected(s, l);
}

vec3 environmentLight(Shading s, float visibility, float occlusion) {
  vec3 r = reflect(-s.view, s.normal);
  vec3 radiance = textureLod(specularCube, r, s.roughness * frame.environment.y).rgb;
  vec3 irradiance = textureLod(diffuseCube, s.normal, 0.0).rgb;
  // [Fdez-Aguera 2019] listing 1.
  vec3 singleScatter = s.f0 * s.brdf.x + s.brdf.y;
  float lost = s.brdf.z;
  vec3 average = meanFresnel(s.f0);
  vec3 multiScatter = lost * singleScatter * average / (1.0 - average * lost);
  vec3 diffuse = s.diffuseColor * (1.0 - singleScatter - multiScatter);
  // [Lagarde and de Rousiers 2014, Moving Frostbite to PBR, listing 26], the exponent too.
  float ambient = visibility * occlusion;
  float exponent = exp2(-16.0 * s.roughness - 1.0);
  float specularOcclusion = clamp(pow(s.nDotV + ambient, exponent) - 1.0 + ambient, 0.0, 1.0);
  return singleScatter * radiance * specularOcclusion +
         (multiScatter + diffuse) * irradiance * ambient;
}

/// Light on its way to the camera: part is lost to haze, which glows like the sky at the horizon.
vec3 throughHaze(Shading s, vec3 light) {
  if (frame.environment.x == 0.0 || frame.cameraPosition.w == 0.0)
    return light;
  // Above the horizon by 1.6 texels of the built-in sky, so that filtering meets no ground.
  const float kAboveHorizon = 0.01;
  float distance = length(frame.cameraPosition.xyz - s.position);
  vec3 horizon = normalize(vec3(-s.view.x, kAboveHorizon, -s.view.z));
  vec3 haze = textureLod(panorama, panoramaCoordinate(horizon), 0.0).rgb;
  return mix(haze, light, exp(-distance * frame.environment.x));
}

#endif
