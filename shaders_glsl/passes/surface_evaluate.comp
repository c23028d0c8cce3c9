#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Evaluates one map of a noise at a list of points of surfaces:
// points[k] (position, its gradients, normal, tangent) -> values[k] (RGBA of the decoded quantity).
// For tests and for engines that bake a noise into the texture or the vertices of a mesh.

#define LICHEN_METHODS 10
#define LICHEN_OMIT_TRIPLANAR
#define LICHEN_SET 0
#include "../lichen.glsl"
#include "one_role.glsl"

const int kValue = 0;
const int kGaussian = 1; // the Gaussian value; 1
const int kImpacts = 2;  // how many reach the point, in all components; of textons
const int kLost = 3;     // the share of the variance that filtering loses of each channel; 0
layout(constant_id = 0) const int kQuantity = kValue;

// The tangent's w is glTF's, the others' the weight of a mix: of the gradients and the normal its
// weight and its derivatives per tile, of the position 0 where the material says them.
struct Point {
  vec4 position;
  vec4 gradientX, gradientY, normal;
  vec4 tangent;
};

layout(local_size_x = 64) in;
layout(std430, set = 1, binding = 0) readonly buffer Points { Point points[]; };
layout(std430, set = 1, binding = 1) writeonly buffer Values { vec4 values[]; };

vec4 evaluated(texture2D image, texture3D table, Point point) {
  LichenMap map = lichenMaps[kRole];
  LichenShadingPoint shading = LICHEN_POINT_SURFACE(point.position.xyz, point.gradientX.xyz,
                                           point.gradientY.xyz, point.normal.xyz, point.tangent);
  if (point.position.w != 0.0)
    lichenSetMix(shading.point.texton, point.gradientX.w, vec2(point.gradientY.w, point.normal.w));
  if (kQuantity == kImpacts)
    return vec4(float(lichenSurfaceImpactCount(shading.surface.texton)));
  if (kQuantity == kValue)
    return lichenValue(image, table, shading, map);
  vec3 lost;
  vec3 gaussian = lichenSurfaceGaussian(image, table, shading.surface, shading.point,
                                        lichenMaterial, lichenNoise, map, lost);
  return kQuantity == kLost ? vec4(lost, 0.0) : vec4(gaussian, 1.0);
}

void main() {
  uint index = gl_GlobalInvocationID.x;
  if (index >= uint(points.length()))
    return;
  vec4 value = vec4(0.0);
  LICHEN_EVALUATE(value, points[index]);
  values[index] = value;
}
