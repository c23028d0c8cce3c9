#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Evaluates the first map of a texton noise at a list of points:
// points[k] (uv, its gradients, place in a mix) -> values[k] (RGBA of the decoded quantity).
// For tests and for engines that fill a texture from a noise at run time.

#define LICHEN_TILING_NOISES 0
#define LICHEN_OMIT_TRIPLANAR
#define LICHEN_SET 0
#define LICHEN_MAP_COUNT 1
#include "../lichen.glsl"

const int kValue = 0;
const int kGaussian = 1; // the Gaussian value; 1
const int kGradient = 2; // stored value of the first channel, its derivatives per tile; 0
const int kImpacts = 3;  // how many reach the point, in all components
const int kLost = 4;     // the share of the variance that filtering loses of each channel; 0
layout(constant_id = 0) const int kQuantity = kValue;

struct Point {
  vec4 uvAndGradientX;
  vec4 gradientY; // zw unused
  vec4 mixPlace;  // weight, its derivatives per tile; w is 0 where the material says them
};

layout(local_size_x = 64) in;
layout(std430, set = 1, binding = 0) readonly buffer Points { Point points[]; };
layout(std430, set = 1, binding = 1) writeonly buffer Values { vec4 values[]; };

vec4 gradientAt(Point point) {
  LichenImpacts impacts =
      lichenGradientPlaceUvGrad(point.uvAndGradientX.xy, point.uvAndGradientX.zw,
                                point.gradientY.xy, lichenUniforms.noise, lichenUniforms.texton);
  if (point.mixPlace.w != 0.0)
    lichenSetMix(impacts, point.mixPlace.x, point.mixPlace.yz);
  return vec4(lichenTextonGradient(lichenImage0, lichenTable0, impacts, lichenUniforms.noise,
                                   lichenUniforms.maps[0], lichenUniforms.texton),
              0.0);
}

void main() {
  uint index = gl_GlobalInvocationID.x;
  if (index >= uint(points.length()))
    return;
  Point point = points[index];
  LichenNoise noise = lichenUniforms.noise;
  LichenMap map = lichenUniforms.maps[0];
  LichenTexton texton = lichenUniforms.texton;
  LichenPlace place =
      LICHEN_PLACE(point.uvAndGradientX.xy, point.uvAndGradientX.zw, point.gradientY.xy);
  if (point.mixPlace.w != 0.0)
    lichenSetMix(place.impacts, point.mixPlace.x, point.mixPlace.yz);
  LichenMap here = lichenMixedMap(lichenTable0, place.impacts, map, texton);
  LichenKept kept = lichenTextonKept(lichenTable0, place.impacts, map, texton);
  if (kQuantity == kGaussian)
    values[index] =
        vec4(lichenTextonGaussian(lichenImage0, place.impacts, kept, noise, here, texton), 1.0);
  else if (kQuantity == kLost)
    values[index] = vec4(1.0 - kept.seen, 0.0);
  else if (kQuantity == kGradient)
    values[index] = gradientAt(point);
  else if (kQuantity == kImpacts)
    values[index] = vec4(float(lichenImpactCount(place.impacts, noise, texton)));
  else
    values[index] = LICHEN_NOISE(0, place);
}
