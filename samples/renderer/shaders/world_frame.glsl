// SPDX-License-Identifier: MIT
// Transforms a vertex's normal and tangent to world space, and computes its attributes in object
// space. Normals transform by the cofactor matrix, which also exists for singular matrices;
// mirroring flips them.
#ifndef WORLD_FRAME_GLSL
#define WORLD_FRAME_GLSL

#ifndef NOISE_POINT_GLSL // which declares it too
// Whether any noise of the scene lies in object space.
layout(constant_id = 5) const bool kObjectSpaces = false;
#endif

void toWorld(mat4 worldFromObject, vec3 normal, vec4 tangent, out vec3 worldNormal,
             out vec4 worldTangent) {
  mat3 linear = mat3(worldFromObject);
  mat3 cofactors = mat3(cross(linear[1], linear[2]), cross(linear[2], linear[0]),
                        cross(linear[0], linear[1]));
  float mirror = dot(linear[0], cofactors[0]) < 0.0 ? -1.0 : 1.0;
  worldNormal = mirror * (cofactors * normal);
  worldTangent = vec4(linear * tangent.xyz, mirror * tangent.w);
}

/// A vertex in object space, and `worldOutward`, the world-space result of a unit step along its
/// normal. All outputs are 0 if no noise of the scene needs them.
void inObject(vec3 position, vec3 normal, vec4 tangent, mat4 worldFromObject,
              out vec3 objectPosition, out vec3 objectNormal, out vec4 objectTangent,
              out vec3 worldOutward) {
  objectPosition = objectNormal = worldOutward = vec3(0.0);
  objectTangent = vec4(0.0);
  if (!kObjectSpaces)
    return;
  objectPosition = position;
  objectNormal = normal;
  objectTangent = tangent;
  worldOutward = mat3(worldFromObject) * normal;
}

#endif
