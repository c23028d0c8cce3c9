#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Evaluates one map of a noise of either method in three planes at a list of points of
// surfaces: points[k] (position, its gradients, normal) -> values[k] (RGBA of the decoded quantity,
// or of slopes their gradient in space and variance).
// For tests and for engines that bake a noise into the texture or the vertices of a mesh.

#define LICHEN_OTHER_MAPPINGS 0
#define LICHEN_OMIT_SURFACE
#define LICHEN_OMIT_SOLID
#define LICHEN_SET 0
#include "../lichen.glsl"
#include "one_role.glsl"

const int kValue = 0;
const int kGaussian = 1; // the Gaussian value, the first channel's lost variance in alpha
const int kWeights = 2;  // of the planes that look along x, y, z; how many count
layout(constant_id = 0) const int kQuantity = kValue;

struct Point {
  vec4 position;             // w: the weight of a mix, less than 0 where the material says it
  vec4 gradientX, gradientY; // w unused
  vec4 normal;               // w unused
};

layout(local_size_x = 64) in;
layout(std430, set = 1, binding = 0) readonly buffer Points { Point points[]; };
layout(std430, set = 1, binding = 1) writeonly buffer Values { vec4 values[]; };

vec4 evaluated(texture2D image, texture3D table, Point point) {
  LichenMap map = lichenMaps[kRole];
  LichenShadingPoint shading = LICHEN_POINT_TRIPLANAR(point.position.xyz, point.gradientX.xyz,
                                             point.gradientY.xyz, point.normal.xyz);
  if (point.position.w >= 0.0)
    lichenSetMix(shading.point.texton, point.position.w, vec2(0.0));
  if (kQuantity == kWeights)
    return vec4(lichenPlaneWeights(point.normal.xyz, lichenMaterial),
                float(shading.triplanar.count));
  if (kQuantity == kGaussian) {
    vec3 lost;
    vec3 gaussian = lichenTriplanarGaussian(image, table, shading.triplanar, shading.point,
                                            lichenNoise, map, lost);
    return vec4(gaussian, lost.x);
  }
  return lichenValue(image, table, shading, map);
}

void main() {
  uint index = gl_GlobalInvocationID.x;
  if (index >= uint(points.length()))
    return;
  vec4 value = vec4(0.0);
  LICHEN_EVALUATE(value, points[index]);
  values[index] = value;
}
