// SPDX-License-Identifier: MIT
// The attributes of a vertex, and how displacement moves it -> a SurfaceVertex.
#ifndef DISPLACED_ATTRIBUTES_GLSL
#define DISPLACED_ATTRIBUTES_GLSL

#include "displaced_vertex.glsl"
#include "world_frame.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec2 texCoord0;
layout(location = 4) in vec2 texCoord1;
layout(location = 5) in vec4 color;
layout(location = 6) in float vertexMixWeight;
layout(location = 7) in vec4 directionAndWeight;
layout(location = 8) in float texCoordsPerUnit;

SurfaceVertex vertexInWorld() {
  mat4 world = worldFromObject();
  SurfaceVertex v;
  v.worldPosition = (world * vec4(position, 1.0)).xyz;
  toWorld(world, normal, tangent, v.worldNormal, v.worldTangent);
  vec4 noTangent;
  toWorld(world, directionAndWeight.xyz, vec4(0.0), v.direction, noTangent);
  float length2 = dot(v.direction, v.direction);
  if (length2 > 0.0)
    v.direction *= inversesqrt(length2);
  v.relief = vec2(directionAndWeight.w, texCoordsPerUnit / scaleOfObject());
  inObject(position, normal, tangent, world, v.objectPosition, v.objectNormal, v.objectTangent,
           v.worldOutward);
  v.texCoords = vec4(texCoord0, texCoord1);
  v.vertexColor = color;
  v.mixWeight = vertexMixWeight;
  return v;
}

#endif
