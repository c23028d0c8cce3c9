// SPDX-License-Identifier: MIT
// Any noise at a point: the one place that knows all methods. Each method has, for its own type of
// point, in its own file:
//   lichenSetPoint   what all maps share at a point of a plane; lichenSetSurfacePoint and
//                    lichenSetSolidPoint where it has surfaces and solids
//   lichenGaussianAt the Gaussian value of a map there, and what filtering lost of it;
//                    lichenSurfaceGaussianAt, lichenSolidGaussianAt
// Decoding (decode.glsl) and mappings (mapping/) name no method.

/// What all maps of a noise share at one point; the member of its method is set.
struct LichenPoint {
#if (LICHEN_METHODS & 1) != 0
  LichenTilingPoint tiling;
#endif
#if (LICHEN_METHODS & 2) != 0
  LichenImpacts texton;
#endif
#if (LICHEN_METHODS & 4) != 0
  LichenCosinesPoint localRandomPhase;
#endif
#if (LICHEN_METHODS & 8) != 0
  LichenKernelsPoint multipleKernels;
#endif
#if (LICHEN_METHODS & 16) != 0
  LichenQuiltingPoint quilting;
#endif
};

/// The point at `position` [tiles, relative to the host's integer tile origin] of a pixel with
/// these gradients [tiles / pixel].
LichenPoint lichenPointAt(vec2 position, vec2 gradientX, vec2 gradientY, LichenMaterial material,
                          LichenNoise noise) {
  LichenPoint point;
#if (LICHEN_METHODS & 1) != 0
  if (lichenHasMethod(LICHEN_METHOD_TILING, noise))
    lichenSetPoint(point.tiling, position, gradientX, gradientY, material, noise);
#endif
#if (LICHEN_METHODS & 2) != 0
  if (lichenHasMethod(LICHEN_METHOD_TEXTON, noise))
    lichenSetPoint(point.texton, position, gradientX, gradientY, material, noise);
#endif
#if (LICHEN_METHODS & 4) != 0
  if (lichenHasMethod(LICHEN_METHOD_LOCAL_RANDOM_PHASE, noise))
    lichenSetPoint(point.localRandomPhase, position, gradientX, gradientY, material, noise);
#endif
#if (LICHEN_METHODS & 8) != 0
  if (lichenHasMethod(LICHEN_METHOD_MULTIPLE_KERNELS, noise))
    lichenSetPoint(point.multipleKernels, position, gradientX, gradientY, material, noise);
#endif
#if (LICHEN_METHODS & 16) != 0
  if (lichenHasMethod(LICHEN_METHOD_QUILTING, noise))
    lichenSetPoint(point.quilting, position, gradientX, gradientY, material, noise);
#endif
  return point;
}

#if LICHEN_HAS_SURFACES
/// Sets what a point has on a surface beside its footprint in the tangent plane: `position` [tile
/// widths, relative to the host's integer tile origin]; the columns of `frame` point to the right,
/// down and outward in the exemplar, orthonormal.
void lichenSetOnSurface(LICHEN_INOUT(LichenPoint) point, vec3 position, mat3 frame,
                        LichenMaterial material, LichenNoise noise) {
#if (LICHEN_METHODS & 2) != 0
  if (lichenHasMethod(LICHEN_METHOD_TEXTON, noise))
    lichenSetSurfacePoint(point.texton, position, frame, material, noise);
#endif
#if (LICHEN_METHODS & 8) != 0
  if (lichenHasMethod(LICHEN_METHOD_MULTIPLE_KERNELS, noise))
    lichenSetSurfacePoint(point.multipleKernels, position, frame, material, noise);
#endif
}
#endif

#if LICHEN_HAS_SOLIDS
/// The point of a solid at `position` [tiles, relative to the host's integer tile origin; along z as
/// long as wide] of a pixel with these gradients [tiles / pixel].
LichenPoint lichenPointInSolid(vec3 position, vec3 gradientX, vec3 gradientY,
                               LichenMaterial material, LichenNoise noise) {
  LichenPoint point;
  LichenSolidFootprint footprint = lichenSolidFootprint(gradientX, gradientY, noise);
#if (LICHEN_METHODS & 4) != 0
  if (lichenHasMethod(LICHEN_METHOD_LOCAL_RANDOM_PHASE, noise))
    lichenSetSolidPoint(point.localRandomPhase, position, footprint, material);
#endif
#if (LICHEN_METHODS & 8) != 0
  if (lichenHasMethod(LICHEN_METHOD_MULTIPLE_KERNELS, noise))
    lichenSetSolidPoint(point.multipleKernels, position, footprint, material);
#endif
  return point;
}
#endif

/// Sets the weight of a mix of textons at a point: 0 is the first step, 1 the last. `gradient` is
/// its derivative along x and y of tile space [1 / tile], which gives the weight at the impacts
/// around. Where the weight is continuous, the gradient must be too. Pass 0 where it is not, as for
/// vertex colours, which bend at every edge: all impacts then have the point's own weight, and
/// neighbouring steps differ little.
void lichenSetMix(LICHEN_INOUT(LichenPoint) point, float weight, vec2 gradient) {
#if (LICHEN_METHODS & 2) != 0
  point.texton.mixWeight = weight;
  point.texton.mixGradient = gradient;
#endif
}

float lichenMixWeightAt(LichenPoint point) {
#if (LICHEN_METHODS & 2) != 0
  return point.texton.mixWeight;
#else
  return 0.0;
#endif
}

/// The map's constants at a point; a mix of textons has other ones for each weight. `table` is the
/// image at the map's binding, here and below.
LichenMap lichenMapAt(LICHEN_IMAGE_3D table, LichenPoint point, LichenNoise noise, LichenMap map) {
#if (LICHEN_METHODS & 2) != 0
  if (lichenHasMethod(LICHEN_METHOD_TEXTON, noise))
    return lichenMixedMap(table, point.texton, noise, map);
#endif
  return map;
}

/// The Gaussian value of a map, as lichenMapAt has it, in a plane.
LichenGaussian lichenGaussianAt(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table, LichenPoint point,
                                LichenMaterial material, LichenNoise noise, LichenMap map) {
  LichenGaussian gaussian = LichenGaussian(vec3(0.5), vec3(0.0), 0.0);
#if (LICHEN_METHODS & 1) != 0
  if (lichenHasMethod(LICHEN_METHOD_TILING, noise))
    gaussian = lichenGaussianAt(image, table, point.tiling, material, noise, map);
#endif
#if (LICHEN_METHODS & 2) != 0
  if (lichenHasMethod(LICHEN_METHOD_TEXTON, noise))
    gaussian = lichenGaussianAt(image, table, point.texton, material, noise, map);
#endif
#if (LICHEN_METHODS & 4) != 0
  if (lichenHasMethod(LICHEN_METHOD_LOCAL_RANDOM_PHASE, noise))
    gaussian = lichenGaussianAt(image, table, point.localRandomPhase, material, noise, map);
#endif
#if (LICHEN_METHODS & 8) != 0
  if (lichenHasMethod(LICHEN_METHOD_MULTIPLE_KERNELS, noise))
    gaussian = lichenGaussianAt(image, table, point.multipleKernels, material, noise, map);
#endif
#if (LICHEN_METHODS & 16) != 0
  if (lichenHasMethod(LICHEN_METHOD_QUILTING, noise))
    gaussian = lichenGaussianAt(image, table, point.quilting, material, noise, map);
#endif
  return gaussian;
}

/// The value of a map in a plane. For slopes, z is the variance of a slope lost to filtering.
vec4 lichenValueAt(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table, LichenPoint point,
                   LichenMaterial material, LichenNoise noise, LichenMap map) {
  vec4 value;
#if (LICHEN_METHODS & 1) != 0
  if (lichenHasMethod(LICHEN_METHOD_TILING, noise)) {
    value = lichenTilingValue(image, table, point.tiling, material, noise, map);
  } else
#endif
  {
    LichenMap here = lichenMapAt(table, point, noise, map);
    LichenGaussian gaussian = lichenGaussianAt(image, table, point, material, noise, here);
    value = lichenDecode(table, gaussian, material.contrast, here);
  }
  return value;
}

#if LICHEN_HAS_SURFACES
/// The Gaussian value on a surface.
LichenGaussian lichenSurfaceGaussian(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table,
                                     LichenPoint point, LichenMaterial material, LichenNoise noise,
                                     LichenMap map) {
  LichenGaussian gaussian = LichenGaussian(vec3(0.5), vec3(0.0), 0.0);
#if (LICHEN_METHODS & 2) != 0
  if (lichenHasMethod(LICHEN_METHOD_TEXTON, noise))
    gaussian = lichenSurfaceGaussianAt(image, table, point.texton, material, noise, map);
#endif
#if (LICHEN_METHODS & 8) != 0
  if (lichenHasMethod(LICHEN_METHOD_MULTIPLE_KERNELS, noise))
    gaussian = lichenSurfaceGaussianAt(image, table, point.multipleKernels, material, noise, map);
#endif
  return gaussian;
}
#endif

#if LICHEN_HAS_SOLIDS
/// The Gaussian value in a solid.
LichenGaussian lichenSolidGaussian(LICHEN_IMAGE_2D image, LichenPoint point,
                                   LichenMaterial material, LichenNoise noise, LichenMap map) {
  LichenGaussian gaussian = LichenGaussian(vec3(0.5), vec3(0.0), 0.0);
#if (LICHEN_METHODS & 4) != 0
  if (lichenHasMethod(LICHEN_METHOD_LOCAL_RANDOM_PHASE, noise))
    gaussian = lichenSolidGaussianAt(image, point.localRandomPhase, material, noise, map);
#endif
#if (LICHEN_METHODS & 8) != 0
  if (lichenHasMethod(LICHEN_METHOD_MULTIPLE_KERNELS, noise))
    gaussian = lichenSolidGaussianAt(image, point.multipleKernels, material, noise, map);
#endif
  return gaussian;
}
#endif
