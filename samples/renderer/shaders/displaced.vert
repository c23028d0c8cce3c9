#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Displaces a mesh whose vertices are close enough as they are.
#include "displacement.glsl"
#include "displaced_attributes.glsl"

void main() { displace(vertexInWorld()); }
