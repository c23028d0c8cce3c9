// SPDX-License-Identifier: MIT
// A vertex of a displaced surface, before displacement, as the stages hand it on.
#ifndef DISPLACED_VERTEX_GLSL
#define DISPLACED_VERTEX_GLSL

#include "scene_interface.h"

layout(push_constant) uniform DisplacedBlock { DisplacedData draw; };

struct SurfaceVertex {
  vec3 worldPosition;
  vec3 worldNormal;
  vec4 worldTangent;
  vec4 texCoords;
  vec4 vertexColor;
  float mixWeight;
  vec3 objectPosition;
  vec3 objectNormal;
  vec4 objectTangent;
  vec3 worldOutward;
  vec3 direction; // of displacement, in the world
  vec2 relief; // x weight of the height; y texture coordinates of the noise per world unit
};

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

#endif
