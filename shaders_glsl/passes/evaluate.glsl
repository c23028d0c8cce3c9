// SPDX-License-Identifier: MIT
// What the passes share that evaluate one map of a noise at a list of points, for tests and for
// engines that fill a texture from a noise at run time: points[k] -> values[k]. A pass defines
// `Point` and pointOf(), its shading point, before it includes this; on texture coordinates also
// gradientOf().
layout(constant_id = 0) const int kQuantity = 0;
const int kValue = 0;    // RGBA of the decoded quantity; of slopes in space their gradient, variance
const int kGaussian = 1; // the Gaussian value; the share of the first channel's variance that is lost
const int kGradient = 2; // on texture coordinates: the first channel, its derivatives per tile; 0
const int kLost = 3;     // the share of each channel's variance that is lost; 0
layout(constant_id = 1) const int kRole = LICHEN_BASE_COLOR;

layout(local_size_x = 64) in;
layout(std430, set = 1, binding = 0) readonly buffer Points { Point points[]; };
layout(std430, set = 1, binding = 1) writeonly buffer Values { vec4 values[]; };

vec4 evaluated(texture2D image, texture3D table, Point point) {
  LichenMap map = lichenMaps[kRole];
  LichenShadingPoint shading = pointOf(point);
#if LICHEN_MAPPINGS == 1
  if (kQuantity == kGradient)
    return gradientOf(image, table, point, map);
#endif
  if (kQuantity == kValue)
    return lichenValue(image, table, shading, map);
  LichenGaussian gaussian = lichenGaussian(image, table, shading, map);
  return kQuantity == kLost ? vec4(gaussian.lost, 0.0) : vec4(gaussian.value, gaussian.lost.x);
}

#define EVALUATE_ROLE(role)                                                                        \
  if (kRole == role)                                                                               \
  values[index] = evaluated(LICHEN_IMAGE(role), LICHEN_TABLE(role), points[index])

void main() {
  uint index = gl_GlobalInvocationID.x;
  if (index >= uint(points.length()))
    return;
  EVALUATE_ROLE(LICHEN_BASE_COLOR);
  EVALUATE_ROLE(LICHEN_NORMAL);
  EVALUATE_ROLE(LICHEN_OCCLUSION_ROUGHNESS_METALLIC);
  EVALUATE_ROLE(LICHEN_EMISSIVE);
  EVALUATE_ROLE(LICHEN_HEIGHT);
  EVALUATE_ROLE(LICHEN_OPACITY);
}
