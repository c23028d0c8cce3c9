// SPDX-License-Identifier: MIT
// glTF's metallic-roughness model under punctual lights and an environment [glTF 2.0, appendix B].
// Multiple scattering: of lights [Kulla and Conty 2017, Revisiting Physically Based Shading at
// Imageworks], of the environment [Fdez-Aguera 2019, A Multiple-Scattering Microfacet Model for
// Real-Time Image-based Lighting]. GGX [Walter et al. 2007, eq. 33]; Smith visibility [Heitz 2014,
// eq. 99]; Fresnel [Schlick 1994].
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
  float spread; // tangent of the angles between the normal and the four of setSpread(); often 0
  vec3 across; // unit vectors orthogonal to the normal and to each other; unset if spread is 0
  vec3 along;
  vec3 view; // toward the camera
  float nDotV;
  vec3 diffuseColor;
  vec3 f0;
  float roughness;
  float alpha;
  vec4 brdf; // scale and bias of f0 under a uniform environment; energy loss; its mean
};

float alphaOf(float roughness) { return max(roughness * roughness, kLeastAlpha); }

/// Bumps that filtering has averaged away tilt parts of the surface. Diffuse light is the mean over
/// four normals whose slopes have the same mean and covariance as the bumps'. One normal would be
/// too bright under the sun: bumps of deviation 0.2 reflect 3 % less than a plane.
void setSpread(inout Shading s, float slopeVariance) {
  s.spread = sqrt(2.0 * slopeVariance);
  if (s.spread == 0.0)
    return;
  vec3 other = abs(s.normal.y) < 0.5 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
  s.across = normalize(cross(other, s.normal));
  s.along = cross(s.normal, s.across);
}

/// Normal k of the four.
vec3 tiltedNormal(Shading s, int k) {
  vec3 axis = k < 2 ? s.across : s.along;
  return normalize(s.normal + ((k & 1) == 0 ? s.spread : -s.spread) * axis);
}

/// Cosine of a bump's normal to a direction, bounded by the bump's own shadow. Below the horizon of
/// the geometric normal it is 0; toward the horizon it fades by Smith shadowing: at an elevation e,
/// bumps of slope a leave 2 e / a of the cosine a [Heitz 2014, eqs. 43 and 72]. The bound is the
/// same for resolved bumps, so brightness does not depend on the distance.
float shadowedCosine(Shading s, vec3 normal, vec3 l) {
  return clamp(dot(normal, l), 0.0, max(2.0 * dot(s.geometricNormal, l), 0.0));
}

/// Mean cosine of the bumps to a direction.
float meanCosine(Shading s, vec3 l) {
  if (s.spread == 0.0)
    return shadowedCosine(s, s.normal, l);
  float sum = 0.0;
  for (int k = 0; k < 4; ++k)
    sum += shadowedCosine(s, tiltedNormal(s, k), l);
  return 0.25 * sum;
}

/// Mean irradiance of the bumps by the environment, over pi.
vec3 meanIrradiance(Shading s) {
  if (s.spread == 0.0)
    return textureLod(diffuseCube, s.normal, 0.0).rgb;
  vec3 sum = vec3(0.0);
  for (int k = 0; k < 4; ++k)
    sum += textureLod(diffuseCube, tiltedNormal(s, k), 0.0).rgb;
  return 0.25 * sum;
}

const float kMeanSchlick = 1.0 / 21.0; // cosine-weighted mean of Schlick's power

vec3 meanFresnel(vec3 f0) { return f0 + (1.0 - f0) * kMeanSchlick; }

/// [Kulla and Conty 2017, "Multiple scattering"]: a lobe with the energy that single scattering
/// loses. Symmetric in light and view, unlike a factor on single scattering.
vec3 scatteredAgain(Shading s, float nDotL) {
  const float kLeastLost = 1e-5; // for a mirror
  float lostOfLight = textureLod(brdfTable, vec2(nDotL, s.roughness), 0.0).z;
  float lostOfView = s.brdf.z;
  float lost = max(s.brdf.w, kLeastLost);
  vec3 average = meanFresnel(s.f0);
  vec3 color = average * average * (1.0 - lost) / (1.0 - average * lost);
  return color * (lostOfLight * lostOfView / (kPi * lost));
}

/// Light reflected from a light in direction l with irradiance 1 on a surface that faces it.
vec3 reflected(Shading s, vec3 l) {
  float cosine = meanCosine(s, l);
  if (cosine <= 0.0)
    return vec3(0.0);
  vec3 h = l + s.view; // zero if the view is along the light, with the surface at grazing angles
  h = dot(h, h) > 1e-8 ? normalize(h) : s.normal;
  float vDotH = clamp(dot(s.view, h), 0.0, 1.0);
  vec3 fresnel = s.f0 + (1.0 - s.f0) * pow(1.0 - vDotH, kSchlickPower);
  vec3 diffuse = cosine * (1.0 - fresnel) * s.diffuseColor / kPi;
  float nDotL = shadowedCosine(s, s.normal, l);
  if (nDotL == 0.0) // the light reaches tilted bumps only
    return diffuse;
  float nDotH = clamp(dot(s.normal, h), 0.0, 1.0);
  float a2 = s.alpha * s.alpha;
  float d = nDotH * nDotH * (a2 - 1.0) + 1.0;
  float distribution = a2 / (kPi * d * d);
  float visibility = 0.5 / (nDotL * sqrt(s.nDotV * s.nDotV * (1.0 - a2) + a2) +
                            s.nDotV * sqrt(nDotL * nDotL * (1.0 - a2) + a2));
  vec3 specular = fresnel * (distribution * visibility) + scatteredAgain(s, nDotL);
  return diffuse + nDotL * specular;
}

// Offset of the four taps of the shadow filter. Each tap is a tent of one texel's radius (bilinear
// comparison); two tents one texel apart add up to a trapezoid that is flat in its middle.
const float kShadowTapTexels = 0.5;
// Radius r of the shadow filter along an axis. A surface lifted by r along its normal does not
// shadow itself: for a plane at angle a to the light, lifting gains r / cos a toward the light, and
// the plane rises by at most r tan a. (The filter reaches farther along diagonals; the depth maps'
// slope bias covers that.)
const float kShadowReachTexels = kShadowTapTexels + 1.0;

/// Visibility of the sun from four taps with hardware comparison. This and the functions below
/// sample an explicit level: control flow is not uniform, so implicit derivatives are undefined.
float sunVisibility(Shading s) {
  vec3 lifted = s.position + s.geometricNormal * (kShadowReachTexels * frame.shadow.x);
  vec3 shading = (frame.sunFromWorld * vec4(lifted, 1.0)).xyz;
  if (any(lessThan(shading.xy, vec2(0.0))) || any(greaterThan(shading.xy, vec2(1.0))))
    return 1.0;
  vec2 texel = kShadowTapTexels / vec2(textureSize(sunDepth, 0));
  float depth = min(shading.z, 1.0);
  return 0.25 * (textureLod(sunDepth, vec3(shading.xy + vec2(-texel.x, -texel.y), depth), 0.0) +
                 textureLod(sunDepth, vec3(shading.xy + vec2(texel.x, -texel.y), depth), 0.0) +
                 textureLod(sunDepth, vec3(shading.xy + vec2(-texel.x, texel.y), depth), 0.0) +
                 textureLod(sunDepth, vec3(shading.xy + texel, depth), 0.0));
}

/// The unoccluded share of the upper sky, weighted by the cosine to the normal. One frame samples a
/// few directions; the average of frames samples many.
float skyVisibility(Shading s) {
  const float kLeast = 0.02; // avoids 0 / 0 for a normal that faces none of the directions
  vec3 lifted = s.position + s.geometricNormal * (kShadowReachTexels * frame.shadow.y);
  float seen = kLeast;
  float all = kLeast;
  for (int k = 0; k < frame.counts.y; ++k) {
    float weight = max(dot(s.normal, frame.skyDirection[k].xyz), 0.0);
    vec3 shading = (frame.skyFromWorld[k] * vec4(lifted, 1.0)).xyz;
    bool outside = any(lessThan(shading.xy, vec2(0.0))) || any(greaterThan(shading.xy, vec2(1.0)));
    // textureLod does not support sampler2DArrayShadow in this GLSL version; zero gradients also
    // select level 0.
    float open = 1.0;
    if (!outside)
      open = textureGrad(skyDepth, vec4(shading.xy, float(k), min(shading.z, 1.0)), vec2(0.0),
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
  const float kLeastSquared = 1e-8; // for a point at the light's position
  float squared = max(dot(toLight, toLight), kLeastSquared);
  vec3 l = toLight * inversesqrt(squared);
  float attenuation = 1.0 / squared;
  if (light.directionAndRange.w > 0.0) {
    // Range window of KHR_lights_punctual.
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
  vec3 irradiance = meanIrradiance(s);
  // [Fdez-Aguera 2019] listing 1.
  vec3 singleScatter = s.f0 * s.brdf.x + s.brdf.y;
  float lost = s.brdf.z;
  vec3 average = meanFresnel(s.f0);
  vec3 multiScatter = lost * singleScatter * average / (1.0 - average * lost);
  vec3 diffuse = s.diffuseColor * (1.0 - singleScatter - multiScatter);
  // [Lagarde and de Rousiers 2014, Moving Frostbite to PBR, listing 26], including the exponent.
  float ambient = visibility * occlusion;
  float exponent = exp2(-16.0 * s.roughness - 1.0);
  float specularOcclusion = clamp(pow(s.nDotV + ambient, exponent) - 1.0 + ambient, 0.0, 1.0);
  return singleScatter * radiance * specularOcclusion +
         (multiScatter + diffuse) * irradiance * ambient;
}

/// Attenuates light by haze on its way to the camera; the haze has the colour of the sky at the
/// horizon.
vec3 throughHaze(Shading s, vec3 light) {
  if (frame.environment.x == 0.0 || frame.cameraPosition.w == 0.0)
    return light;
  // 1.6 texels of the built-in sky above the horizon, so that filtering does not reach the ground.
  const float kAboveHorizon = 0.01;
  float distance = length(frame.cameraPosition.xyz - s.position);
  vec3 horizon = normalize(vec3(-s.view.x, kAboveHorizon, -s.view.z));
  vec3 haze = textureLod(panorama, panoramaCoordinate(horizon), 0.0).rgb;
  return mix(haze, light, exp(-distance * frame.environment.x));
}

#endif
