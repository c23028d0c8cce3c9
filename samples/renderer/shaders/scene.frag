#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// A surface's radiance toward the camera, or one of its quantities (debug views).
#include "scene_interface.h"
#include "surface.glsl"
#include "debug_views.glsl"
#include "shading.glsl"

const float kLeastNDotV = 1e-3; // keeps the visibility term finite

layout(location = 0) in vec3 worldPosition;
layout(location = 1) in vec3 worldNormal;
layout(location = 2) in vec4 worldTangent;
layout(location = 3) in vec4 texCoords;
layout(location = 4) in vec4 vertexColor;
layout(location = 5) in float mixWeight;
layout(location = 6) in vec3 objectPosition;
layout(location = 7) in vec3 objectNormal;
layout(location = 8) in vec4 objectTangent;
layout(location = 9) in vec3 worldOutward;
layout(location = 10) in vec3 displacedPosition; // the noise's position is worldPosition
layout(location = 0) out vec4 color;

/// Whether the surface is displaced, but no map has the slopes of its relief.
bool needsSlopes() {
  return kHasNoise && !kHasNormalMap && material.fromTileOrigin.w > 0.0 &&
         !NOISE_HAS(LICHEN_NORMAL);
}

/// The normal of the displaced triangle, or `n` if that is too small for floats.
vec3 triangleNormal(vec3 n, vec3 view) {
  vec3 normal = cross(dFdx(displacedPosition), dFdy(displacedPosition));
  float length2 = dot(normal, normal);
  if (length2 <= 0.0)
    return n;
  return normal * (dot(normal, view) < 0.0 ? -inversesqrt(length2) : inversesqrt(length2));
}

/// The tangent, and in w the sign of the bitangent, which points to lesser v: the file's, or
/// without it by the derivatives of the texture coordinates of the normals.
vec4 tangentAt(vec3 n) {
  if (worldTangent.xyz != vec3(0.0))
    return worldTangent;
  bool isOfNoise = kHasNoise && NOISE_HAS(LICHEN_NORMAL);
  bool isFirstSet = (isOfNoise ? material.flags.w : material.texCoords.z) == 0;
  vec2 uvX = isFirstSet ? dFdx(texCoords.xy) : dFdx(texCoords.zw);
  vec2 uvY = isFirstSet ? dFdy(texCoords.xy) : dFdy(texCoords.zw);
  vec3 x = dFdx(worldPosition), y = dFdy(worldPosition);
  float turn = uvX.x * uvY.y < uvX.y * uvY.x ? -1.0 : 1.0;
  vec3 alongU = turn * (x * uvY.y - y * uvX.y), alongV = turn * (y * uvX.x - x * uvY.x);
  vec3 outward = gl_FrontFacing ? n : -n;
  return vec4(alongU, dot(cross(outward, alongU), alongV) < 0.0 ? 1.0 : -1.0);
}

vec3 shadingNormal(vec3 n, vec3 view, Surface surface) {
  if (needsSlopes())
    return triangleNormal(n, view);
  if (!kHasNormalMap && !(kHasNoise && NOISE_HAS(LICHEN_NORMAL)))
    return n;
  if (kHasNoise && surface.gradient != vec3(0.0))
    return lichenNormalFromGradient(n, surface.gradient);
  vec3 tangentNormal = surface.tangentNormal;
  vec4 tangent = tangentAt(n);
  vec3 t = tangent.xyz - n * dot(n, tangent.xyz);
  float length2 = dot(t, t);
  if (length2 <= 0.0)
    return n;
  t *= inversesqrt(length2);
  vec3 b = cross(n, t) * tangent.w;
  if (!gl_FrontFacing)
    t = -t; // the normal is flipped, so flip the whole frame; the cross product has flipped b
  return normalize(t * tangentNormal.x + b * tangentNormal.y + n * tangentNormal.z);
}

Shading prepare(Surface surface, vec3 geometricNormal) {
  Shading s;
  s.position = displacedPosition;
  s.geometricNormal = geometricNormal;
  s.view = frame.cameraPosition.w != 0.0 ? normalize(frame.cameraPosition.xyz - s.position)
                                         : -frame.cameraForward.xyz;
  s.normal = shadingNormal(geometricNormal, s.view, surface);
  // A normal map may tilt the normal away from the camera.
  s.nDotV = clamp(dot(s.normal, s.view), kLeastNDotV, 1.0);
  setSpread(s, surface.slopeVariance);
  s.roughness = clamp(surface.roughness, 0.0, 1.0);
  s.alpha = alphaOf(s.roughness);
  float metallic = clamp(surface.metallic, 0.0, 1.0);
  s.diffuseColor = surface.baseColor.rgb * (1.0 - metallic);
  s.f0 = mix(vec3(kDielectricF0), surface.baseColor.rgb, metallic);
  s.brdf = textureLod(brdfTable, vec2(s.nDotV, s.roughness), 0.0);
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

void main() {
  float scale = frame.environment.z;
  Footprint footprint =
      Footprint(texCoords, dFdx(texCoords) * scale, dFdy(texCoords) * scale,
                Spot(worldPosition, dFdx(worldPosition) * scale, dFdy(worldPosition) * scale,
                     worldNormal, worldTangent),
                Spot(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec4(0.0)), vec3(0.0), mixWeight);
  if (kObjectSpaces) {
    footprint.object = Spot(objectPosition, dFdx(objectPosition) * scale,
                            dFdy(objectPosition) * scale, objectNormal, objectTangent);
    footprint.worldOutward = worldOutward;
  }
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
  else if (kDebugView == DEBUG_ROUGHNESS)
    shown = vec3(s.roughness);
  else if (kDebugView == DEBUG_METALLIC)
    shown = vec3(surface.metallic);
  else if (kDebugView == DEBUG_OCCLUSION)
    shown = vec3(surface.occlusion);
  else
    shown = noiseDebug(footprint);
  color = vec4(shown, surface.baseColor.a);
}
