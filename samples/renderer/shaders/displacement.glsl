// SPDX-License-Identifier: MIT
// Moves a vertex by the height of its noise, and writes the outputs of scene.vert. Everything here
// depends on the vertex alone, not on its triangle, so triangles stay together.
#ifndef DISPLACEMENT_GLSL
#define DISPLACEMENT_GLSL

#include "noise_point.glsl"
#include "displaced_vertex.glsl"

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
float heightAt(SurfaceVertex v, float side) {
  float uvSide = side * v.relief.y;
  Spot nowhere = Spot(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec4(0.0));
  // The direction, not the normal, is the same at coincident vertices.
  Footprint f = Footprint(v.texCoords, vec4(uvSide, 0.0, uvSide, 0.0),
                          vec4(0.0, uvSide, 0.0, uvSide),
                          spotAt(v.worldPosition, v.direction, v.worldTangent, side), nowhere,
                          vec3(0.0), v.mixWeight);
  if (kObjectSpaces)
    f.object = spotAt(v.objectPosition, v.objectNormal, v.objectTangent, side / scaleOfObject());
  float height = NOISE_VALUE(LICHEN_HEIGHT, noisePoint(f)).x;
  // Values above 1 would leave the bounds that culling and shadows count with.
  return clamp(mix(lichenMaps[LICHEN_HEIGHT].mean.x, height, v.relief.x), 0.0, 1.0);
}

void displace(SurfaceVertex v) {
  precise vec3 displaced = v.worldPosition;
  float length2 = dot(v.direction, v.direction);
  if (LICHEN_HAS(LICHEN_HEIGHT) && length2 > 0.0) {
    v.direction *= inversesqrt(length2);
    float depth = dot(clipDepth(), vec4(v.worldPosition, 1.0));
    float height = heightAt(v, max(depth, 0.0) * draw.pixels.y);
    displaced += material.fromTileOrigin.w * height * v.direction;
  }
  worldPosition = v.worldPosition;
  worldNormal = v.worldNormal;
  worldTangent = v.worldTangent;
  texCoords = v.texCoords;
  vertexColor = v.vertexColor;
  mixWeight = v.mixWeight;
  objectPosition = v.objectPosition;
  objectNormal = v.objectNormal;
  objectTangent = v.objectTangent;
  worldOutward = v.worldOutward;
  displacedPosition = displaced;
  gl_Position = draw.clipFromWorld * vec4(displaced, 1.0);
}

#endif
