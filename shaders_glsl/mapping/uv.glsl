// SPDX-License-Identifier: MIT
// A noise on texture coordinates: where it is evaluated, and how its slopes become normals.
// uv (float2) and its screen-space gradients -> LichenShadingPoint; slopes (float2) -> normal in
// tangent space; their variance lost to filtering -> roughness.
#ifndef LICHEN_UV_GLSL
#define LICHEN_UV_GLSL

#include "../noise/cosine_gradient.glsl"
#include "../noise/mix_point.glsl"
#include "../noise/shading_point.glsl"
#include "../noise/texton_gradient.glsl"
#include "../noise/tile_frame.glsl"

/// The shading point at `uv` with explicit gradients: usable in compute and in non-uniform control
/// flow.
LichenShadingPoint lichenPointUvGrad(vec2 uv, vec2 uvGradientX, vec2 uvGradientY,
                                     LichenMaterial material, LichenNoise noise) {
  vec2 position = vec2(material.offsetX, material.offsetY) + lichenUvToTile(uv, material);
  LichenShadingPoint shading;
  shading.material = material;
  shading.noise = noise;
  shading.point = lichenPointAt(position, lichenUvToTile(uvGradientX, material),
                                lichenUvToTile(uvGradientY, material), material, noise);
  lichenSetMixFromUv(shading.point, uv, material, noise);
  return shading;
}

/// The value of a map's first channel at `position` [tiles] and its derivatives along x and y of
/// tile space [1 / tile], for bumps of a height. Tiling and quilting have none, and give 0. The
/// weight of a mix and its derivatives are those that lichenSetMix takes.
vec3 lichenGradientAt(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table, vec2 position, vec2 gradientX,
                      vec2 gradientY, float mixWeight, vec2 mixGradient, LichenMaterial material,
                      LichenNoise noise, LichenMap map) {
#ifdef LICHEN_HAS_LOCAL_RANDOM_PHASE
  if (lichenHasMethod(LICHEN_METHOD_LOCAL_RANDOM_PHASE, noise))
    return lichenCosinesGradient(image, table, position, gradientX, gradientY, material, noise,
                                 map);
#endif
#ifdef LICHEN_HAS_MULTIPLE_KERNELS
  if (lichenHasMethod(LICHEN_METHOD_MULTIPLE_KERNELS, noise))
    return lichenKernelsGradient(image, table, position, gradientX, gradientY, material, noise,
                                 map);
#endif
#ifdef LICHEN_HAS_TEXTONS
  if (lichenHasMethod(LICHEN_METHOD_TEXTON, noise)) {
    LichenImpacts impacts =
        lichenGradientImpactsAt(position, gradientX, gradientY, material, noise);
    lichenSetMix(impacts, mixWeight, mixGradient);
    return lichenTextonGradient(image, table, impacts, material, noise, map);
  }
#endif
  LichenPoint point = lichenPointAt(position, gradientX, gradientY, material, noise);
  return vec3(lichenValueAt(image, table, point, material, noise, map).x, 0.0, 0.0);
}

/// The same at `uv`, with the material's weight of a mix.
vec3 lichenGradientUvGrad(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table, vec2 uv, vec2 uvGradientX,
                          vec2 uvGradientY, LichenMaterial material, LichenNoise noise,
                          LichenMap map) {
  return lichenGradientAt(
      image, table, vec2(material.offsetX, material.offsetY) + lichenUvToTile(uv, material),
      lichenUvToTile(uvGradientX, material), lichenUvToTile(uvGradientY, material),
      lichenMixWeight(uv, material), lichenMixGradient(material), material, noise, map);
}

/// The unit tangent-space normal of slopes (-nx/nz, -ny/nz).
vec3 lichenNormalFromSlopes(vec2 slopes) { return normalize(vec3(-slopes, 1.0)); }

/// The perceptual roughness of a microfacet surface whose slopes vary by `slopeVariance`, along
/// each axis, where the footprint does not show it: a slope map's z, times the square of what
/// multiplies the slopes. Neither rotation nor scale of the texture coordinates changes it.
float lichenRoughness(float roughness, float slopeVariance) {
  // [OB10] section 3, [TK19] eq. 3: a facet's slopes have the variance alpha^2 / 2 along each axis
  // (of GGX, the Beckmann's that it stands for), and variances add.
  float alpha = roughness * roughness;
  return sqrt(sqrt(min(1.0, alpha * alpha + 2.0 * max(0.0, slopeVariance))));
}

#endif
