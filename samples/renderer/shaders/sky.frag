#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// The background: the environment's panorama.
#include "panorama.glsl"
#include "scene_interface.h"

layout(std140, set = SET_FRAME, binding = BINDING_FRAME) uniform FrameBlock { FrameData frame; };
layout(set = SET_FRAME, binding = BINDING_PANORAMA) uniform sampler2D panorama;

layout(location = 0) in vec2 clip;
layout(location = 0) out vec4 color;

void main() {
  vec4 far = frame.worldFromClip * vec4(clip, 0.5, 1.0);
  vec3 direction = frame.cameraPosition.w != 0.0
                       ? normalize(far.xyz / far.w)
                       : frame.cameraForward.xyz;
  // Level 0, because derivatives jump where the longitude wraps.
  color = vec4(textureLod(panorama, panoramaCoordinate(direction), 0.0).rgb, 1.0);
}
