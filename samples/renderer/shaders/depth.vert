#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Vertices to the clip space of a light.
#include "scene_interface.h"

layout(push_constant) uniform DepthBlock { DepthData draw; };

layout(location = 0) in vec3 position;
layout(location = 3) in vec2 texCoord0;
layout(location = 4) in vec2 texCoord1;
layout(location = 5) in vec4 color;
layout(location = 6) in float vertexMixWeight;

layout(location = 0) out vec4 texCoords;
layout(location = 1) out float vertexAlpha;
layout(location = 2) out float mixWeight;

void main() {
  texCoords = vec4(texCoord0, texCoord1);
  vertexAlpha = color.a;
  mixWeight = vertexMixWeight;
  gl_Position = draw.clipFromObject * vec4(position, 1.0);
}
