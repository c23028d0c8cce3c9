#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Divides the edges of a triangle into parts of the vertex spacing. Parts depend on the ends of the
// edge alone, in any order, so the triangles on both sides agree.
#include "displaced_vertex.glsl"

layout(std140, set = SET_MATERIAL, binding = BINDING_MATERIAL) uniform MaterialBlock {
  MaterialData material;
};

layout(vertices = 3) out;
layout(location = 0) in SurfaceVertex corners[];
layout(location = 0) out SurfaceVertex patchCorners[];

const float kMostParts = 64.0; // [Vulkan, maxTessellationGenerationLevel]
const float kLeastDepth = 1e-30;

/// An edge is measured at its nearer end, as if it lay across the view.
float partsOf(vec3 a, vec3 b) {
  precise vec4 depth = clipDepth();
  precise float depthOfA = dot(depth, vec4(a, 1.0));
  precise float depthOfB = dot(depth, vec4(b, 1.0));
  float nearest = min(depthOfA, depthOfB) - length(depth.xyz) * material.fromTileOrigin.w;
  float parts = distance(a, b) * draw.pixels.x / max(nearest, kLeastDepth);
  return clamp(parts, 1.0, kMostParts);
}

/// Whether the triangle, however displaced, is beyond this plane, whose xyz points into the view.
bool isBeyond(vec4 plane) {
  float most = max(dot(plane, vec4(corners[0].worldPosition, 1.0)),
                   max(dot(plane, vec4(corners[1].worldPosition, 1.0)),
                       dot(plane, vec4(corners[2].worldPosition, 1.0))));
  return most + length(plane.xyz) * material.fromTileOrigin.w < 0.0;
}

bool isOutOfView() {
  mat4 rows = transpose(draw.clipFromWorld);
  return isBeyond(rows[3] + rows[0]) || isBeyond(rows[3] - rows[0]) ||
         isBeyond(rows[3] + rows[1]) || isBeyond(rows[3] - rows[1]) || isBeyond(rows[2]) ||
         isBeyond(rows[3] - rows[2]);
}

void main() {
  patchCorners[gl_InvocationID] = corners[gl_InvocationID];
  if (gl_InvocationID != 0)
    return;
  vec3 parts = vec3(0.0); // discards the patch
  if (!isOutOfView())
    parts = vec3(partsOf(corners[1].worldPosition, corners[2].worldPosition),
                 partsOf(corners[2].worldPosition, corners[0].worldPosition),
                 partsOf(corners[0].worldPosition, corners[1].worldPosition));
  gl_TessLevelOuter[0] = parts.x;
  gl_TessLevelOuter[1] = parts.y;
  gl_TessLevelOuter[2] = parts.z;
  gl_TessLevelInner[0] = max(parts.x, max(parts.y, parts.z));
}
