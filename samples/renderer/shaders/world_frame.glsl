// SPDX-License-Identifier: MIT
// A vertex's directions in the world. Normals transform by the cofactors, which a singular matrix
// has too; mirroring turns them.
#ifndef WORLD_FRAME_GLSL
#define WORLD_FRAME_GLSL

void toWorld(mat4 worldFromObject, vec3 normal, vec4 tangent, out vec3 worldNormal,
             out vec4 worldTangent) {
  mat3 linear = mat3(worldFromObject);
  mat3 cofactors = mat3(cross(linear[1], linear[2]), cross(linear[2], linear[0]),
                        cross(linear[0], linear[1]));
  float mirror = dot(linear[0], cofactors[0]) < 0.0 ? -1.0 : 1.0;
  worldNormal = mirror * (cofactors * normal);
  worldTangent = vec4(linear * tangent.xyz, mirror * tangent.w);
}

#endif
