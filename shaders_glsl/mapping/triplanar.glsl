// SPDX-License-Identifier: MIT
// A noise in three planes in space: a point, its screen-space derivatives and the normal there ->
// LichenShadingPoint; the gradient of slopes -> normal. Needs neither texture coordinates nor
// tangents.
// Planes look along x, y and z. Each shows one field through all of space: the same from both sides
// of a sheet, and mirrored on the far face of a body (docs/decisions/013-triplanar.md).

// The shader scales the largest weight to 1, subtracts this from all three and skips planes below
// 0, so weights have no jump. A plane of this weight moves an 8-bit value, whose deviation is an
// eighth of the range, by half a step.
const float kLichenLeastPlaneWeight = 1.0 / 64.0;

#if LICHEN_HAS_TRIPLANAR
/// Weights of the planes that look along x, y and z; their squares sum to 1.
vec3 lichenPlaneWeights(vec3 normal, LichenMaterial material) {
  vec3 slant = abs(normal);
  slant /= max(slant.x, max(slant.y, slant.z));
  vec3 weights = max(pow(slant, vec3(material.planeSharpness)) - kLichenLeastPlaneWeight, 0.0);
  return weights * inversesqrt(dot(weights, weights));
}

/// The shading point at `position` [metres, relative to the host's integer tile origin], with the
/// position's derivatives along the screen: usable in compute and in non-uniform control flow. The
/// `normal` is not 0, of any length and either side.
LichenShadingPoint lichenPointTriplanarGrad(vec3 position, vec3 positionGradientX,
                                            vec3 positionGradientY, vec3 normal,
                                            LichenTriplanarMaterial planes, LichenNoise noise) {
  LichenMaterial material = planes.material;
  vec3 weights = lichenPlaneWeights(normal, material);
  // The greatest first, and those that do not count last.
  int first =
      weights.x >= weights.y ? (weights.x >= weights.z ? 0 : 2) : (weights.y >= weights.z ? 1 : 2);
  int second = first == 2 ? 0 : first + 1;
  int third = 3 - first - second;
  if (lichenChosen(weights, second) < lichenChosen(weights, third)) {
    int swapped = second;
    second = third;
    third = swapped;
  }
  LichenShadingPoint shading;
  shading.material = material;
  shading.noise = noise;
  shading.triplanar.position = position;
  shading.triplanar.gradientX = positionGradientX;
  shading.triplanar.gradientY = positionGradientY;
  shading.triplanar.normal = normalize(normal);
  shading.triplanar.weights = weights;
  shading.triplanar.order = ivec3(first, second, third);
  shading.triplanar.count = int(weights.x > 0.0) + int(weights.y > 0.0) + int(weights.z > 0.0);
  shading.triplanar.planes = planes;
  lichenSetMix(shading.point, lichenMixWeight(vec2(0.0), material), vec2(0.0));
  return shading;
}
#endif

/// The unit normal of a surface whose slopes have this gradient in space, on any side of it.
vec3 lichenNormalFromGradient(vec3 normal, vec3 gradient) {
  // [M20], the surface gradient: of that in space, what lies in the surface.
  vec3 outward = normalize(normal);
  return normalize(outward - gradient + dot(gradient, outward) * outward);
}
