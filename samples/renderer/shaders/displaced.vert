#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Moves a vertex by the height of its noise, and writes the outputs of scene.vert. Everything here
// depends on the vertex alone, not on its triangle, so triangles stay together. The vertices are
// close enough as they are.
#include "scene_interface.h"
#include "noise_point.glsl"
#include "world_frame.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec2 texCoord0;
layout(location = 4) in vec2 texCoord1;
layout(location = 5) in vec4 color;
layout(location = 6) in float vertexMixWeight;
layout(location = 7) in vec4 directionAndWeight; // of displacement, and of the height
layout(location = 8) in float texCoordsPerUnit; // of the noise, per unit of the object

layout(location = 0) out vec3 worldPosition;
layout(location = 1) out vec3 worldNormal;
layout(location = 2) out vec4 worldTangent;
layout(location = 3) out vec4 texCoords;
layout(location = 4) out vec4 vertexColor;
layout(location = 5) out float mixWeight;
layout(location = 6) out vec3 objectPosition;
layout(location = 7) out vec3 objectNormal;
layout(location = 8) out vec4 objectTangent;
layout(location = 9) out vec3 worldOutward;
layout(location = 10) out vec3 displacedPosition;

layout(push_constant) uniform DisplacedBlock { DisplacedData draw; };

mat4 worldFromObject() {
  return transpose(mat4(draw.worldRows[0], draw.worldRows[1], draw.worldRows[2],
                        vec4(0.0, 0.0, 0.0, 1.0)));
}

/// World units of a unit of the object, on average over all directions.
float scaleOfObject() {
  const float kLeast = 1e-20; // of an object that is scaled to a plane
  return pow(max(abs(determinant(mat3(worldFromObject()))), kLeast), 1.0 / 3.0);
}

/// The homogeneous coordinate w of a position and, in xyz, its gradient. It is the depth of a
/// perspective view, 1 of a parallel one.
vec4 clipDepth() {
  return vec4(draw.clipFromWorld[0].w, draw.clipFromWorld[1].w, draw.clipFromWorld[2].w,
              draw.clipFromWorld[3].w);
}

/// A point with a round footprint, `side` wide.
Spot spotAt(vec3 position, vec3 normal, vec4 tangent, float side) {
  vec3 other = abs(normal.y) < abs(normal.x) ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
  vec3 across = cross(other, normal);
  vec3 along = cross(normal, across);
  float across2 = dot(across, across);
  float along2 = dot(along, along);
  if (across2 > 0.0 && along2 > 0.0) {
    across *= side * inversesqrt(across2);
    along *= side * inversesqrt(along2);
  }
  return Spot(position, across, along, normal, tangent);
}

/// The height of the noise where the footprint is `side` world units wide.
float heightAt(vec3 direction, float side) {
  float uvSide = side * texCoordsPerUnit / scaleOfObject();
  Spot nowhere = Spot(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec4(0.0));
  // The direction, not the normal, is the same at coincident vertices.
  Footprint f = Footprint(texCoords, vec4(uvSide, 0.0, uvSide, 0.0),
                          vec4(0.0, uvSide, 0.0, uvSide),
                          spotAt(worldPosition, direction, worldTangent, side), nowhere, vec3(0.0),
                          mixWeight);
  if (kObjectSpaces)
    f.object = spotAt(objectPosition, objectNormal, objectTangent, side / scaleOfObject());
  float height = NOISE_VALUE(LICHEN_HEIGHT, noisePoint(f)).x;
  // Values above 1 would leave the bounds that culling and shadows count with.
  return clamp(mix(lichenMaps[LICHEN_HEIGHT].mean.x, height, directionAndWeight.w), 0.0, 1.0);
}

void main() {
  mat4 world = worldFromObject();
  worldPosition = (world * vec4(position, 1.0)).xyz;
  toWorld(world, normal, tangent, worldNormal, worldTangent);
  inObject(position, normal, tangent, world, objectPosition, objectNormal, objectTangent,
           worldOutward);
  texCoords = vec4(texCoord0, texCoord1);
  vertexColor = color;
  mixWeight = vertexMixWeight;
  vec3 direction;
  vec4 noTangent;
  toWorld(world, directionAndWeight.xyz, vec4(0.0), direction, noTangent);
  float length2 = dot(direction, direction);
  precise vec3 displaced = worldPosition;
  if (LICHEN_HAS(LICHEN_HEIGHT) && length2 > 0.0) {
    direction *= inversesqrt(length2);
    float depth = dot(clipDepth(), vec4(worldPosition, 1.0));
    float height = heightAt(direction, max(depth, 0.0) * draw.footprint.x);
    displaced += material.fromTileOrigin.w * height * direction;
  }
  displacedPosition = displaced;
  gl_Position = draw.clipFromWorld * vec4(displaced, 1.0);
}
