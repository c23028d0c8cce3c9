// SPDX-License-Identifier: MIT
// A point where a noise is evaluated, whatever its method and mapping: a host computes it once per
// fragment (mapping/) and evaluates each of the noise's maps there (lichenValue).

/// What all maps of a noise share at one point.
struct LichenShadingPoint {
  LichenMaterial material;
  LichenNoise noise;
  LichenPoint point;
#if LICHEN_HAS_TRIPLANAR
  LichenTriplanar triplanar; // set where the mapping is triplanar, `point` but for its mix elsewhere
#endif
};

/// The Gaussian value of one map: mean 1/2, deviation 1/6 where nothing is lost.
LichenGaussian lichenGaussian(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table,
                              LichenShadingPoint shading, LichenMap map) {
  LichenMap here = lichenMapAt(table, shading.point, shading.noise, map);
#if LICHEN_HAS_TRIPLANAR
  if (lichenIsTriplanar(shading.material))
    return lichenTriplanarGaussian(image, table, shading.triplanar, shading.point, shading.noise,
                                   here);
#endif
#if LICHEN_HAS_SURFACES
  if (lichenIsSurface(shading.material))
    return lichenSurfaceGaussian(image, table, shading.point, shading.material, shading.noise, here);
#endif
#if LICHEN_HAS_SOLIDS
  if (lichenIsSolid(shading.material))
    return lichenSolidGaussian(image, shading.point, shading.material, shading.noise, here);
#endif
  return lichenGaussianAt(image, table, shading.point, shading.material, shading.noise, here);
}

/// The value of one map: light for colours, the decoded quantity for the others. For slopes, z is
/// the variance of a slope lost to filtering, for lichenRoughness; triplanar and solid ones are a
/// gradient in space, and the variance is w.
vec4 lichenValue(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table, LichenShadingPoint shading,
                 LichenMap map) {
  bool isSlope = map.encoding == uint(LICHEN_ENCODING_SLOPE);
#if LICHEN_HAS_TRIPLANAR
  if (lichenIsTriplanar(shading.material) && isSlope)
    return lichenTriplanarSlopes(image, table, shading.triplanar, shading.point, shading.noise,
                                 map);
#endif
  if (!lichenHasSlopesInSpace(shading.material) &&
      !lichenIsSurface(shading.material))
    return lichenValueAt(image, table, shading.point, shading.material, shading.noise, map);
  LichenGaussian gaussian = lichenGaussian(image, table, shading, map);
  vec4 value = lichenDecode(table, gaussian, shading.material.contrast,
                            lichenMapAt(table, shading.point, shading.noise, map));
  if (isSlope && lichenIsSolid(shading.material))
    value = vec4(lichenSlopesToUv(value.xy, shading.material), gaussian.depthSlope, value.z);
  return value;
}
