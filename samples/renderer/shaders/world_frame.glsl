// SPDX-License-Identifier: MIT
// Transforms a vertex's normal and tangent to world space, and computes its attributes in object
// space. Normals transform by the cofactor matrix, which also exists for singular matrices;
// mirroring flips them.
#ifndef WORLD_FRAME_GLSL
#define WORLD_FRAME_GLSL

#ifndef NOISE_POINT_GLSL // which declares it too
// Whether any noise of the scene lies in object space.
layout(constant_id = 6) const bool kObjectSpaces = false;
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

/// A vertex in object space before morph targets and skinning, and `worldOutward`, the world-space
/// result of a unit step along its normal. The length of `undeformedNormal` is the factor by which
/// the skin stretches space along it. All outputs are 0 if no noise of the scene needs them.
void inObject(vec3 undeformedPosition, vec3 undeformedNormal, vec4 undeformedTangent, vec3 normal,
              mat4 worldFromObject, out vec3 objectPosition, out vec3 objectNormal,
              out vec4 objectTangent, out vec3 worldOutward) {
  objectPosition = objectNormal = worldOutward = vec3(0.0);
  objectTangent = vec4(0.0);
  if (!kObjectSpaces)
    return;
  float stretch = length(undeformedNormal);
  objectPosition = undeformedPosition;
  objectNormal = undeformedNormal;
  if (stretch > 0.0)
    objectNormal /= stretch;
  objectTangent = undeformedTangent;
  worldOutward = mat3(worldFromObject) * (stretch * normal);
}

#endif
