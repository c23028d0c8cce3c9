#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Evaluates the first map of a texton noise at a list of points of surfaces:
// points[k] (position, its gradients, normal, tangent) -> values[k] (RGBA of the decoded quantity).
// For tests and for engines that bake a noise into the texture or the vertices of a mesh.

#define LICHEN_TILING_NOISES 0
#define LICHEN_OMIT_TRIPLANAR
#define LICHEN_SET 0
#define LICHEN_MAP_COUNT 1
#include "../lichen.glsl"

const int kValue = 0;
const int kGaussian = 1; // the Gaussian value; 1
const int kImpacts = 2;  // how many reach the point, in all components
const int kLost = 3;     // the share of the variance that filtering loses of each channel; 0
layout(constant_id = 0) const int kQuantity = kValue;

// The tangent's w is glTF's, the others' the place in a mix: of the gradients and the normal its
// weight and its derivatives per tile, of the position 0 where the material says them.
struct Point {
  vec4 position;
  vec4 gradientX, gradientY, normal;
  vec4 tangent;
};

layout(local_size_x = 64) in;
layout(std430, set = 1, binding = 0) readonly buffer Points { Point points[]; };
layout(std430, set = 1, binding = 1) writeonly buffer Values { vec4 values[]; };

void main() {
  uint index = gl_GlobalInvocationID.x;
  if (index >= uint(points.length()))
    return;
  Point point = points[index];
  LichenNoise noise = lichenUniforms.noise;
  LichenMap map = lichenUniforms.maps[0];
  LichenTexton texton = lichenUniforms.texton;
  LichenPlace place = LICHEN_PLACE_SURFACE(point.position.xyz, point.gradientX.xyz,
                                           point.gradientY.xyz, point.normal.xyz, point.tangent);
  if (point.position.w != 0.0)
    lichenSetMix(place.impacts, point.gradientX.w, vec2(point.gradientY.w, point.normal.w));
  LichenMap here = lichenMixedMap(lichenTable0, place.impacts, map, texton);
  LichenKept kept = lichenTextonKept(lichenTable0, place.impacts, map, texton);
  if (kQuantity == kGaussian)
    values[index] = vec4(lichenSurfaceTextonGaussian(lichenImage0, place.impacts, place.surface,
                                                     kept, noise, here, texton),
                         1.0);
  else if (kQuantity == kLost)
    values[index] = vec4(1.0 - kept.seen, 0.0);
  else if (kQuantity == kImpacts)
    values[index] = vec4(float(lichenSurfaceImpactCount(place.surface, noise, texton)));
  else
    values[index] = LICHEN_NOISE(0, place);
}
