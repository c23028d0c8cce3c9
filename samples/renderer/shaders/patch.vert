#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Hands a corner of a patch to the tessellator.
#include "displaced_attributes.glsl"

layout(location = 0) out SurfaceVertex corner;

void main() { corner = vertexInWorld(); }
