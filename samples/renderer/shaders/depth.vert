#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Transforms vertices to the clip space of a light.
#include "scene_interface.h"
#include "world_frame.glsl"

layout(push_constant) uniform DepthBlock { DepthData draw; };

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec2 texCoord0;
layout(location = 4) in vec2 texCoord1;
layout(location = 5) in vec4 color;
layout(location = 6) in float vertexMixWeight;

// As in scene.vert.
layout(location = 0) out vec3 worldPosition;
layout(location = 1) out vec3 worldNormal;
layout(location = 2) out vec4 worldTangent;
layout(location = 3) out vec4 texCoords;
layout(location = 4) out vec4 vertexColor;
layout(location = 5) out float mixWeight;
layout(location = 6) out vec3 objectPosition;
layout(location = 7) out vec3 objectNormal;
layout(location = 8) out vec4 objectTangent;

void main() {
  texCoords = vec4(texCoord0, texCoord1);
  vertexColor = color;
  mixWeight = vertexMixWeight;
  worldPosition = (draw.worldFromObject * vec4(position, 1.0)).xyz;
  toWorld(draw.worldFromObject, normal, tangent, worldNormal, worldTangent);
  vec3 worldOutward; // only needed for slopes, which depth does not use
  inObject(position, normal, tangent, draw.worldFromObject, objectPosition, objectNormal,
           objectTangent, worldOutward);
  gl_Position = draw.clipFromObject * vec4(position, 1.0);
}
